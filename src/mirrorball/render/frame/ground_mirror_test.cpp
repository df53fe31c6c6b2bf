// The mirror image of a scene in a polished ground; its truth is traced in trace/surroundings_test.cpp.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "formula/proxy.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

/// A ball that shines everywhere alike.
Scene lampBall(float radiance) {
  Material material;
  material.unlit = true;
  material.emission = glm::vec3(radiance);
  material.base_color = glm::vec3(radiance);
  return meshScene(sphereMesh(), material);
}

FrameSettings onGround(const std::string& roughness) {
  FrameSettings settings;
  settings.size = {80, 80};
  settings.samples = 4;
  settings.resolve = Resolve::radiance;
  settings.camera = {.azimuth_deg = 0.0f, .elevation_deg = 40.0f, .orthographic_height = 4.0f};
  testing::set(settings, "proxy", "ground:20");
  testing::set(settings, "ground-roughness", roughness);
  return settings;
}

class GroundMirrorTest : public testing::HeadlessTest {
 protected:
  static Image drawn(Scene scene, float environment, const FrameSettings& settings) {
    Renderer renderer =
        testing::rendererFor(std::move(scene), Environment([=](glm::vec3) { return glm::vec3(environment); }, 64));
    return testing::drawn(renderer, settings);
  }

  /// Where a pixel's ray meets the ground below a ball of radius 1 about the origin.
  static glm::vec3 groundAt(int x, int y) {
    const float elevation = glm::radians(40.0f);
    const glm::vec2 across = (glm::vec2(x, 79 - y) + 0.5f) / 80.0f * 4.0f - 2.0f;
    const glm::vec3 up(0.0f, std::cos(elevation), -std::sin(elevation));
    const glm::vec3 place = across.x * glm::vec3(1, 0, 0) + across.y * up;
    return place + kDown * ((place.y + 1.0f) / -kDown.y);
  }
  static inline const glm::vec3 kDown{0.0f, -std::sin(glm::radians(40.0f)), -std::cos(glm::radians(40.0f))};
};

// A smooth ground shows a shining ball by Fresnel's share, exactly where the mirrored ray meets it.
TEST_F(GroundMirrorTest, APolishedGroundShowsTheBallWhereItsRayMeetsIt) {
  const Image image = drawn(lampBall(1.0f), 1e-4f, onGround("0"));
  const float share = formula::fresnelDielectric(-kDown.y, formula::kGroundIor);
  int shown = 0, dark = 0;
  for (int y = 45; y < 80; ++y)
    for (int x = 0; x < 80; ++x) {
      const glm::vec3 place = groundAt(x, y);
      const glm::vec3 mirrored = formula::mirroredByGround(kDown, 0.0f, glm::vec2(0.5f));
      const float along = -glm::dot(place, mirrored);
      const float beside = glm::length(place + along * mirrored);
      const float in_front = glm::length(place - glm::dot(place, kDown) * kDown);
      if (in_front < 1.08f) continue;  // the ball itself, and its edge
      if (along > 0.0f && beside < 0.94f) {
        EXPECT_NEAR(image.texel(x, y)[1], share, 0.01f * share) << x << ", " << y;
        ++shown;
      } else if (along < 0.0f || beside > 1.06f) {
        EXPECT_LT(image.texel(x, y)[1], 2e-4f) << x << ", " << y;
        ++dark;
      }
    }
  EXPECT_GT(shown, 200);
  EXPECT_GT(dark, 200);
}

// What a white scene mirrors takes the place of white: nothing gets brighter than all that there is.
TEST_F(GroundMirrorTest, UnderWhiteLightItIsNeverBrighterThanWhite) {
  for (const std::string roughness : {"0", "0.3", "0.8"}) {
    const Image matt = drawn(lampBall(1.0f), 1.0f, onGround("1"));
    const Image polished = drawn(lampBall(1.0f), 1.0f, onGround(roughness));
    int brighter = 0;
    for (int y = 0; y < 80; ++y)
      for (int x = 0; x < 80; ++x) {
        EXPECT_LE(polished.texel(x, y)[0], 1.0f + 2e-3f) << roughness << " at " << x << ", " << y;
        EXPECT_GE(polished.texel(x, y)[0], matt.texel(x, y)[0] - 2e-3f) << roughness << " at " << x << ", " << y;
        brighter += polished.texel(x, y)[0] > matt.texel(x, y)[0] + 0.01f;
      }
    EXPECT_GT(brighter, 100) << roughness;
  }
}

// The image of a rough ground is blurred, and has about as much light.
TEST_F(GroundMirrorTest, ARoughGroundBlursTheImageAndKeepsItsLight) {
  const Image sharp = drawn(lampBall(1.0f), 1e-4f, onGround("0"));
  const Image rough = drawn(lampBall(1.0f), 1e-4f, onGround("0.35"));
  double sums[2] = {0.0, 0.0};
  int between = 0;
  for (int y = 60; y < 80; ++y)
    for (int x = 0; x < 80; ++x) {
      sums[0] += double(sharp.texel(x, y)[0]);
      sums[1] += double(rough.texel(x, y)[0]);
      between += rough.texel(x, y)[0] > 0.01f && rough.texel(x, y)[0] < 0.04f;
    }
  EXPECT_NEAR(sums[1], sums[0], 0.25 * sums[0]);
  EXPECT_GT(between, 100) << "its edge is soft";
}

// A surface that sees the screen through itself shows the environment behind it in the mirror image, whose camera is
// another one; drivers take seconds for a program of glass.
TEST_F(GroundMirrorTest, TheImageIsDrawnByTheProgramsOfTheFrame) {
  Material glass;
  glass.transmission = 1.0f;
  Renderer renderer = testing::rendererFor(meshScene(sphereMesh(), glass), *builtinEnvironment("studio"));
  FrameSettings settings = onGround("0");
  testing::set(settings, "behind", "screen");
  EXPECT_GT(testing::drawn(renderer, settings).texel(40, 70)[0], 0.0f);
  EXPECT_EQ(renderer.stage().device().state().surfaces().programs().size(), 1);
}

/// A mirror, glass and a matt ball beside each other.
Scene differentBalls() {
  Material mirror, glass;
  mirror.metallic = 1.0f;
  mirror.perceptual_roughness = 0.0f;
  glass.transmission = 1.0f;
  Scene scene;
  testing::addBall(scene, {-1.2f, 0.0f, 0.0f}, 0.5f, mirror, 24);
  testing::addBall(scene, {0.0f, 0.0f, 0.0f}, 0.5f, glass, 24);
  testing::addBall(scene, {1.2f, 0.0f, 0.0f}, 0.5f, {}, 24);
  return scene;
}

/// How many programs the surfaces of a frame have, and how many its mirror image and its probes have beside those.
struct ProgramCounts {
  std::size_t of_frame;
  std::size_t others;
};
ProgramCounts countPrograms(const FrameSettings& settings) {
  Renderer renderer = testing::rendererFor(differentBalls(), testing::coarseBuiltin("studio"));
  EXPECT_TRUE(renderer.begin(settings));
  const std::vector<SurfaceVariant> variants = *renderer.surfaceVariants();
  const std::set<SurfaceVariant> of_frame(variants.begin(), variants.end());
  testing::drawn(renderer, settings);
  return {of_frame.size(), renderer.stage().device().state().surfaces().programs().size() - of_frame.size()};
}

// In a probe's first faces surfaces read the environment's light, since there is none of probes yet, by programs of
// their own; later faces are drawn by the frame's, and so is the mirror image.
TEST_F(GroundMirrorTest, TheImageAddsNoProgramAndProbesOneForEachOfTheFrame) {
  FrameSettings settings = onGround("0");
  testing::set(settings, "behind", "screen");
  const ProgramCounts mirrored = countPrograms(settings);
  EXPECT_EQ(mirrored.of_frame, 3u);
  EXPECT_EQ(mirrored.others, 0u);
  for (const char* bounces : {"1", "2"}) {
    testing::set(settings, "probes", "2");
    testing::set(settings, "probe-bounces", bounces);
    const ProgramCounts with_probes = countPrograms(settings);
    EXPECT_EQ(with_probes.of_frame, 3u) << bounces;
    EXPECT_EQ(with_probes.others, 3u) << bounces;
  }
}

// With a mask for samples, the image tests a stencil of its own, whose pixels are all drawn.
TEST_F(GroundMirrorTest, TheImageIsTheSameWhereSamplesAreMasked) {
  for (const std::string roughness : {"0", "0.35"}) {
    FrameSettings settings = onGround(roughness);
    settings.samples = 16;
    settings.resolve = Resolve::display;
    const auto mean = [&](const char* sampling) {
      testing::set(settings, "sampling", sampling);
      Renderer renderer = testing::rendererFor(lampBall(1.0f), *builtinEnvironment("studio"));
      EXPECT_TRUE(renderer.draw(settings));
      const Image8 picture = *renderer.picture();
      double sum = 0.0;
      for (int y = 60; y < 80; ++y)
        for (int x = 0; x < 80; ++x) sum += double(picture.texel(x, y)[1]) / 1600.0;
      return sum;
    };
    const double whole = mean("all");
    EXPECT_GT(whole, 10.0);
    EXPECT_NEAR(mean("adaptive"), whole, 2.0) << roughness;
  }
}

// Light above the largest half float stays a number where it is blurred.
TEST_F(GroundMirrorTest, AMirroredSunIsFinite) {
  const Image image = drawn(lampBall(1e6f), 1e-4f, onGround("0.35"));
  float brightest = 0.0f;
  for (int y = 60; y < 80; ++y)
    for (int x = 0; x < 80; ++x) {
      ASSERT_TRUE(std::isfinite(image.texel(x, y)[0])) << x << ", " << y;
      brightest = std::max(brightest, image.texel(x, y)[0]);
    }
  EXPECT_GT(brightest, 1e3f);
  EXPECT_LE(brightest, 65504.0f);
}

}  // namespace
}  // namespace mirrorball
