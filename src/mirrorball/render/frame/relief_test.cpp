// Relief of heights, as the renderer draws it.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material_changes.h"

namespace mirrorball {
namespace {

class ReliefTest : public testing::HeadlessTest {
 protected:
  /// A built-in model with these parameters.
  static Image radiance(const char* model, const std::vector<std::string>& set, const Environment& environment,
                        const FrameSettings& settings) {
    Scene scene = *loadModel(model);
    EXPECT_TRUE(changeMaterials(scene, {.material = "plastic", .set = set}));
    EXPECT_TRUE(prepareRelief(scene, settings.relief));
    auto renderer = testing::rendererOf(std::move(scene), environment, *testing::prepareOnce(environment));
    EXPECT_TRUE(renderer);
    auto image = renderer->renderRadiance(settings);
    EXPECT_TRUE(image);
    return std::move(*image);
  }

  static FrameSettings seenFrom(float azimuth, float elevation, ReliefKind relief) {
    FrameSettings settings{.size = {72, 48}, .background = BackgroundKind::transparent, .samples = 4};
    testing::aim(settings, azimuth, elevation);
    settings.relief = relief;
    return settings;
  }
};

constexpr ReliefKind kEveryKind[] = {ReliefKind::none,  ReliefKind::bump,      ReliefKind::parallax,
                                     ReliefKind::steep, ReliefKind::occlusion, ReliefKind::linear_binary,
                                     ReliefKind::cone,  ReliefKind::exact,     ReliefKind::geometry};

/// The share of pixels that differ by more than 2/255 of white, in light or in what is covered.
float shareThatDiffers(const Image& a, const Image& b) {
  int differing = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const glm::vec4 off = glm::abs(rgbaAt(a, x, y) - rgbaAt(b, x, y));
      if (std::max({off.x, off.y, off.z, off.w}) > 2.0f / 255.0f) ++differing;
    }
  return static_cast<float>(differing) / static_cast<float>(a.width() * a.height());
}

TEST_F(ReliefTest, EveryKindIsWhiteInTheFurnace) {
  for (const ReliefKind kind : kEveryKind)
    testing::expectFurnaceWhite(
        radiance("sphere", {"base_color=1", "metallic=1", "perceptual_roughness=0.4", "height=cobbles"},
                 *builtinEnvironment("white"), seenFrom(30, 20, kind)),
        std::to_string(static_cast<int>(kind)), 2e-3f);
}

// So near that a texel is larger than a pixel: of smaller ones each averages the slopes in its own way.
TEST_F(ReliefTest, ExactIsTheSurfaceThatTrianglesShow) {
  for (const char* height : {"height=cobbles", "height=waves"})
    for (const float elevation : {45.0f, 12.0f}) {
      const std::vector<std::string> set = {"base_color=0.5", "perceptual_roughness=0.6", height,
                                            "height_frequency=0.06"};
      const Environment sky = *builtinEnvironment("sky");
      FrameSettings exact = seenFrom(20, elevation, ReliefKind::exact);
      FrameSettings geometry = seenFrom(20, elevation, ReliefKind::geometry);
      exact.samples = geometry.samples = 16;
      const float share = shareThatDiffers(radiance("plane", set, sky, exact), radiance("plane", set, sky, geometry));
      EXPECT_LT(share, 0.04f) << height << " at " << elevation;
    }
}

// Where the relief is carved away at the edge of a plane there is nothing; searches without an outline go on.
TEST_F(ReliefTest, OnlyExactHasAnOutline) {
  const auto covered = [](ReliefKind kind) {
    const Image image =
        radiance("sphere", {"height=cobbles", "height_scale=0.2"}, *builtinEnvironment("white"), seenFrom(0, 0, kind));
    float sum = 0.0f;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) sum += rgbaAt(image, x, y).w;
    return sum;
  };
  const float mesh = covered(ReliefKind::bump);
  EXPECT_NEAR(covered(ReliefKind::linear_binary), mesh, 1e-3f * mesh);
  EXPECT_LT(covered(ReliefKind::exact), 0.93f * mesh);
  EXPECT_NEAR(covered(ReliefKind::exact), covered(ReliefKind::geometry), 0.005f * mesh);
}

// Heights of nothing are the mesh.
TEST_F(ReliefTest, AFlatReliefIsTheMesh) {
  const Environment sky = *builtinEnvironment("sky");
  const Image mesh = radiance("torus", {"perceptual_roughness=0.5"}, sky, seenFrom(30, 30, ReliefKind::none));
  for (const ReliefKind kind : {ReliefKind::bump, ReliefKind::linear_binary, ReliefKind::exact, ReliefKind::geometry}) {
    const Image flat =
        radiance("torus", {"perceptual_roughness=0.5", "height=brick", "height_scale=0"}, sky, seenFrom(30, 30, kind));
    EXPECT_EQ(shareThatDiffers(mesh, flat), 0.0f) << static_cast<int>(kind);
  }
}

// A lamp low above a plane does not reach the joints between stones.
TEST_F(ReliefTest, ReliefShadesItselfFromLamps) {
  const auto lit = [](ReliefKind kind) {
    FrameSettings settings = seenFrom(0, 90, kind);
    settings.env_intensity = 0.0f;
    testing::set(settings, "light", "20,4,0,10,10,10");
    const Image image = radiance("plane", {"base_color=0.8", "specular=0", "perceptual_roughness=1", "height=cobbles"},
                                 *builtinEnvironment("white"), settings);
    float sum = 0.0f;
    for (int y = 16; y < 32; ++y)
      for (int x = 24; x < 48; ++x) sum += rgbAt(image, x, y).y;
    return sum;
  };
  EXPECT_LT(lit(ReliefKind::exact), 0.85f * lit(ReliefKind::bump));
}

}  // namespace
}  // namespace mirrorball
