// How radiance becomes a picture for a display: exposure, tone map, colours behind, dithering, the mean of samples.

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/render/frame/shot_testing.h"

namespace mirrorball {
namespace {

using testing::RendererTest;
using testing::Shot;
using testing::smallShot;
using testing::Studio;

TEST_F(RendererTest, TransparentBackgroundHasPremultipliedAlpha) {
  Studio white = studio("white");
  Shot shot = smallShot("sphere", "mirror");
  shot.frame.background = BackgroundKind::transparent;
  const Image radiance = white.radiance(shot);
  const Image8 picture = white.picture(shot);
  int partial = 0;
  for (int y = 0; y < radiance.height(); ++y)
    for (int x = 0; x < radiance.width(); ++x) {
      const glm::vec4 texel = rgbaAt(radiance, x, y);
      EXPECT_NEAR(texel.x, texel.w, 1e-3f) << "radiance 1 premultiplied by alpha";
      EXPECT_NEAR(picture.texel(x, y)[3] / 255.0f, texel.w, 0.003f);
      if (texel.w <= 0.0f || texel.w >= 1.0f) continue;
      ++partial;
      // Straight alpha: the edge has the colour of the middle.
      EXPECT_NEAR(picture.texel(x, y)[0], picture.texel(48, 32)[0], 1);
    }
  EXPECT_GT(partial, 20);
}

TEST_F(RendererTest, ThePictureIsTheFormulaOfTheRadiance) {
  Studio room = smallStudio("studio");
  Shot shot = smallShot("knot", "gold");
  shot.frame.display.exposure_ev = 0.5f;
  shot.frame.resolve = Resolve::radiance;
  const Image radiance = room.radiance(shot);
  for (const ToneMap curve : {ToneMap::agx, ToneMap::aces, ToneMap::neutral, ToneMap::reinhard, ToneMap::linear}) {
    shot.frame.display.tone_map = curve;
    const Image8 picture = room.picture(shot);
    for (int y = 0; y < radiance.height(); ++y)
      for (int x = 0; x < radiance.width(); ++x) {
        const glm::vec4 shown =
            formula::displayed(rgbaAt(radiance, x, y), std::exp2(0.5f), static_cast<int>(curve)) * 255.0f;
        for (int channel = 0; channel < 4; ++channel)
          EXPECT_NEAR(picture.texel(x, y)[channel], shown[channel], 1.0f) << static_cast<int>(curve);
      }
  }
}

// A mirror and its surroundings in nearly even light: gradients of far less than one code from pixel to pixel.
TEST_F(RendererTest, ADitheredPictureHasTheLightOfItsMean) {
  Studio studio(Environment([](glm::vec3 d) { return glm::vec3(0.21f + 0.01f * d.y); }, 8));
  Shot shot = smallShot("sphere", "mirror");
  shot.frame.samples = 1;
  shot.frame.display.tone_map = ToneMap::linear;
  shot.frame.resolve = Resolve::radiance;
  const Image radiance = studio.radiance(shot);
  const auto worstMean = [&](Dither dither) {
    shot.frame.display.dither = dither;
    const Image8 picture = studio.picture(shot);
    float worst = 0.0f;
    for (int top = 0; top + 8 <= picture.height(); top += 8)
      for (int left = 0; left + 8 <= picture.width(); left += 8) {
        float sum = 0.0f;
        for (int y = top; y < top + 8; ++y)
          for (int x = left; x < left + 8; ++x)
            sum += *picture.texel(x, y) - 255.0f * formula::srgbFromLinear1(*radiance.texel(x, y));
        worst = std::max(worst, std::abs(sum) / 64.0f);
      }
    return worst;
  };
  EXPECT_GT(worstMean(Dither::none), 0.4f);
  EXPECT_LT(worstMean(Dither::pattern), 0.15f);
}

// Whatever the exposure and the curve, and where an edge covers half a pixel, half of its light.
TEST_F(RendererTest, AColourOfTheDisplayIsThatColourInThePicture) {
  Studio room = smallStudio("studio");
  Shot shot = smallShot("knot", "gold");
  shot.frame.display.exposure_ev = 1.5f;
  for (const ToneMap curve : {ToneMap::agx, ToneMap::aces, ToneMap::neutral, ToneMap::reinhard, ToneMap::linear}) {
    shot.frame.display.tone_map = curve;
    shot.frame.background = BackgroundKind::transparent;
    const Image8 cut_out = room.picture(shot);
    for (const auto& [written, code] :
         {std::pair{"#ffffff", glm::ivec3(255)}, {"#336699", glm::ivec3(0x33, 0x66, 0x99)}}) {
      testing::set(shot.frame, "background", written);
      const Image8 picture = room.picture(shot);
      for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
          const std::uint8_t* texel = picture.texel(x, y);
          EXPECT_EQ(texel[3], 255);
          const float alpha = static_cast<float>(cut_out.texel(x, y)[3]) / 255.0f;
          for (int channel = 0; channel < 3; ++channel) {
            if (alpha == 0.0f) {
              ASSERT_EQ(texel[channel], code[channel]) << written;
            }
            const auto light = [](int of_code) {
              return formula::linearFromSrgb1(static_cast<float>(of_code) / 255.0f);
            };
            const float mean = glm::mix(light(code[channel]), light(cut_out.texel(x, y)[channel]), alpha);
            EXPECT_NEAR(texel[channel], 255.0f * formula::srgbFromLinear1(mean), 1.5f) << written << " alpha " << alpha;
          }
        }
    }
  }
}

// A lamp a thousand times brighter than white: an edge pixel that it half covers is half as bright as the display can
// be. The mean of radiance is white wherever one sample of 16 meets the lamp:
// such an edge has steps at any number of samples.
TEST_F(RendererTest, TheOutlineOfALampIsAsSmoothAsItsCoverage) {
  Studio dark(Environment([](glm::vec3) { return glm::vec3(0.0f); }, 8));
  Shot lamp = smallShot("sphere", "");
  lamp.materials.set = {"emission=1000"};
  lamp.frame.samples = 16;
  lamp.frame.background = BackgroundKind::transparent;
  const Image8 cut_out = dark.picture(lamp);
  lamp.frame.background = BackgroundKind::radiance;
  const Image8 resolved = dark.picture(lamp);
  lamp.frame.resolve = Resolve::radiance;
  const Image8 averaged = dark.picture(lamp);
  int partial = 0;
  for (int y = 0; y < cut_out.height(); ++y)
    for (int x = 0; x < cut_out.width(); ++x) {
      const int alpha = cut_out.texel(x, y)[3];
      const float coverage = static_cast<float>(alpha) / 255.0f;
      EXPECT_NEAR(resolved.texel(x, y)[0], 255.0f * formula::srgbFromLinear1(coverage), 1.5f) << "covered " << coverage;
      if (alpha == 0 || alpha == 255) continue;
      ++partial;
      EXPECT_EQ(cut_out.texel(x, y)[0], 255) << "the colour of the middle";
      EXPECT_GE(averaged.texel(x, y)[0], 254) << "covered " << coverage;
    }
  EXPECT_GT(partial, 100);
}

TEST_F(RendererTest, AColourOfTheDisplayIsItsLinearLightAmongRadiance) {
  Studio room = smallStudio("studio");
  Shot shot = smallShot("knot", "gold");
  testing::set(shot.frame, "background", "#336699");
  const Image of_display = room.radiance(shot);
  testing::set(shot.frame, "background", "0.0331048,0.1328683,0.3185468");  // IEC 61966-2-1
  const Image of_radiance = room.radiance(shot);
  ASSERT_EQ(of_display.samples().size(), of_radiance.samples().size());
  for (std::size_t i = 0; i < of_display.samples().size(); ++i)
    ASSERT_NEAR(of_display.samples()[i], of_radiance.samples()[i], 1e-5f);
}

}  // namespace
}  // namespace mirrorball
