// Relief of heights, as the renderer draws it.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "formula/constants.h"
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

/// Pixels within an outline that are not covered or are a tenth darker.
int holesIn(const Image& image, const Image& whole) {
  int holes = 0;
  for (int y = 2; y < image.height() - 2; ++y)
    for (int x = 2; x < image.width() - 2; ++x) {
      float covered = 1.0f;
      for (int beside = -2; beside <= 2; ++beside)
        covered = std::min({covered, rgbaAt(whole, x + beside, y).w, rgbaAt(whole, x, y + beside).w});
      if (covered < 1.0f) continue;
      const glm::vec4 here = rgbaAt(image, x, y);
      if (here.w < 1.0f || here.y < 0.9f * rgbaAt(whole, x, y).y) ++holes;
    }
  return holes;
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

// Prisms at the far end of a plane reach beyond what its triangles need of the camera's depths.
TEST_F(ReliefTest, FarHillsAreNotCutAway) {
  const auto covered = [](ReliefKind kind) {
    FrameSettings settings{.size = {128, 128}, .background = BackgroundKind::transparent, .samples = 1};
    settings.camera = {
        .azimuth_deg = 25.0f, .elevation_deg = 12.0f, .distance = 2.2f, .target = glm::vec3(0.0f), .fov_deg = 40.0f};
    settings.relief = kind;
    const Image image = radiance("plane", {"unlit=yes", "height=waves", "height_frequency=1", "height_scale=0.15"},
                                 *builtinEnvironment("white"), settings);
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) count += rgbaAt(image, x, y).w > 0.5f ? 1 : 0;
    return count;
  };
  EXPECT_NEAR(covered(ReliefKind::exact), covered(ReliefKind::geometry), 8);
}

// Heights of exactly 0 and 1 are met, under a lamp, too: a relief that is all top is the mesh.
TEST_F(ReliefTest, TopsAndBottomsHaveNoHoles) {
  const Environment sky = testing::coarseBuiltin("sky");
  const auto seen = [&](float height, ReliefKind kind) {
    Scene scene = *loadModel("sphere");
    EXPECT_TRUE(changeMaterials(scene, {.material = "plastic", .set = {"perceptual_roughness=0.5"}}));
    scene.height_textures = {*heightTexture(Image(16, 16, 1, height), MapEdges::tiled)};
    for (Material& material : scene.materials) {
      material.height = HeightKind::map;
      material.height_texture = 0;
      material.height_scale = 0.001f;
    }
    EXPECT_TRUE(prepareRelief(scene, kind));
    FrameSettings settings = seenFrom(30, 30, kind);
    testing::set(settings, "light", "3,4,2,10,10,10");
    auto renderer = testing::rendererOf(std::move(scene), sky, *testing::prepareOnce(sky));
    return *renderer->renderRadiance(settings);
  };
  const Image mesh = seen(1.0f, ReliefKind::none);
  for (const ReliefKind kind : {ReliefKind::parallax, ReliefKind::linear_binary, ReliefKind::exact})
    for (const float height : {1.0f, 0.0f})
      EXPECT_EQ(holesIn(seen(height, kind), mesh), 0) << static_cast<int>(kind) << ", " << height;
}

// What else a frame reads from textures stays bound while the relief is looked for.
TEST_F(ReliefTest, ExactLeavesTheSphereMapAlone) {
  const Environment sky = testing::coarseBuiltin("sky");
  FrameSettings exact = seenFrom(30, 30, ReliefKind::exact), none = seenFrom(30, 30, ReliefKind::none);
  exact.mapping = none.mapping = Mapping::sphere;
  const std::vector<std::string> set = {"metallic=1", "perceptual_roughness=0", "height=waves", "height_scale=1e-6"};
  EXPECT_LT(shareThatDiffers(radiance("sphere", set, sky, exact), radiance("sphere", set, sky, none)), 0.01f);
}

// Heights of nothing are the mesh.
TEST_F(ReliefTest, AFlatReliefIsTheMesh) {
  const Environment sky = testing::coarseBuiltin("sky");
  const Image mesh = radiance("torus", {"perceptual_roughness=0.5"}, sky, seenFrom(30, 30, ReliefKind::none));
  for (const ReliefKind kind : {ReliefKind::bump, ReliefKind::linear_binary, ReliefKind::exact, ReliefKind::geometry}) {
    const Image flat =
        radiance("torus", {"perceptual_roughness=0.5", "height=brick", "height_scale=0"}, sky, seenFrom(30, 30, kind));
    EXPECT_EQ(shareThatDiffers(mesh, flat), 0.0f) << static_cast<int>(kind);
  }
}

// A map of more texels than the driver takes shows the same bumps by coarser levels.
TEST_F(ReliefTest, BumpsOfTooManyTexelsAreShown) {
  const Environment sky = testing::coarseBuiltin("sky");
  const auto seen = [&](int width) {
    Image heights(width, 1, 1);
    for (int x = 0; x < width; ++x)
      heights.texel(x, 0)[0] = 0.5f + 0.5f * std::sin(6.0f * formula::kTwoPi * (float(x) + 0.5f) / float(width));
    Scene scene = *loadModel("plane");
    EXPECT_TRUE(changeMaterials(scene, {.material = "plastic", .set = {"perceptual_roughness=0.5"}}));
    scene.height_textures = {HeightTexture{.heights = std::move(heights)}};
    for (Material& material : scene.materials) {
      material.height = HeightKind::map;
      material.height_texture = 0;
      material.height_scale = 0.02f;
      material.height_frequency = 1.0f;
    }
    EXPECT_TRUE(prepareRelief(scene, ReliefKind::bump));
    auto renderer = testing::rendererOf(std::move(scene), sky, *testing::prepareOnce(sky));
    EXPECT_TRUE(renderer) << renderer.error().message;
    return *renderer->renderRadiance(seenFrom(30, 40, ReliefKind::bump));
  };
  EXPECT_EQ(shareThatDiffers(seen(8192), seen(8 * 8192)), 0.0f);
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
