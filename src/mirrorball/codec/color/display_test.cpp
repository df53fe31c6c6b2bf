#include "mirrorball/codec/color/display.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "formula/color.h"

namespace mirrorball {
namespace {

constexpr ToneMap kEvery[] = {ToneMap::agx, ToneMap::aces, ToneMap::neutral, ToneMap::reinhard, ToneMap::linear};

TEST(Display, ShowsWhatTheFormulasSay) {
  for (const ToneMap tone_map : kEvery) {
    Image image(1, 1, 3);
    const glm::vec3 light(0.2f, 1.5f, 40.0f);
    std::copy_n(&light.x, 3, image.texel(0, 0));
    showOn({1.0f, tone_map}, image);
    EXPECT_EQ(rgbAt(image, 0, 0), formula::toneMap(static_cast<int>(tone_map), 2.0f * light));
  }
}

TEST(Display, GreyStaysOneChannelAndAlphaStays) {
  Image grey(1, 1, 1, 0.25f);
  showOn({1.0f, ToneMap::linear}, grey);
  EXPECT_EQ(*grey.texel(0, 0), 0.5f);
  Image disc(2, 1, 4, 0.0f);
  std::fill_n(disc.texel(1, 0), 4, 1.0f);
  for (const ToneMap tone_map : kEvery) {
    Image shown = disc;
    showOn({0.0f, tone_map}, shown);
    EXPECT_EQ(rgbaAt(shown, 0, 0), glm::vec4(0.0f)) << "beside a disc is nothing";
    EXPECT_EQ(rgbaAt(shown, 1, 0).w, 1.0f);
  }
}

// A sun of any radiance is white, or at least no darker than it would be with less.
TEST(Display, NoLightIsTooBright) {
  for (const ToneMap tone_map : kEvery)
    for (const float exposure_ev : {0.0f, 30.0f}) {
      Image suns(4, 1, 3);
      const float lights[] = {1e3f, 1e5f, 1e20f, std::numeric_limits<float>::max()};
      for (int x = 0; x < 4; ++x) std::fill_n(suns.texel(x, 0), 3, lights[x]);
      showOn({exposure_ev, tone_map}, suns);
      for (const float sample : suns.samples()) {
        EXPECT_GT(sample, 0.97f) << static_cast<int>(tone_map) << " at " << exposure_ev;
        EXPECT_LE(sample, 1.0f);
      }
    }
}

TEST(Display, LightBelowZeroIsNone) {
  for (const ToneMap tone_map : kEvery) {
    Image image(1, 1, 3, -5.0f);
    showOn({0.0f, tone_map}, image);
    for (const float sample : image.samples()) EXPECT_NEAR(sample, 0.0f, 2e-3f);
  }
}

}  // namespace
}  // namespace mirrorball
