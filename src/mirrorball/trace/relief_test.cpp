#include "mirrorball/scene/relief/relief.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "mirrorball/rays/geometry.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/trace/path_tracer_testing.h"

namespace mirrorball {
namespace {

using namespace testing;

/// Light from above, brighter from one side.
Environment sideLight() {
  return Environment([](glm::vec3 d) { return glm::vec3(0.3f + 0.7f * std::max(d.x, 0.0f)); }, 16);
}

struct View {
  const char* shape;
  HeightKind height;
  float elevation_deg;
};

Image tracedRelief(const View& view, ReliefKind kind, const Environment& light, glm::ivec2 size, int samples) {
  Material material = matt(0.8f);
  material.height = view.height;
  material.height_scale = 0.1f;
  material.height_frequency = 1.0f;
  Scene scene = shapeOf(view.shape, material);
  const BoundingSphere bounds = boundingSphere(scene);
  EXPECT_TRUE(prepareRelief(scene, kind));
  const Camera camera = makeCamera({.azimuth_deg = 30.0f, .elevation_deg = view.elevation_deg, .distance = 3.0f},
                                   bounds, static_cast<float>(size.x) / static_cast<float>(size.y));
  const auto tracer = PathTracer::make(std::move(scene), light);
  EXPECT_TRUE(tracer) << tracer.error().message;
  auto image = tracer->render(camera, {.size = size, .samples = samples, .bounces = 3, .relief = kind});
  EXPECT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->lost_paths, 0u);
  return std::move(image->radiance);
}

/// The share of pixels that differ by more than that, of 255 as displayed.
double shareThatDiffers(const Image& a, const Image& b, float steps) {
  int count = 0;
  const auto shown = [](float light) { return 255.0f * std::pow(std::clamp(light, 0.0f, 1.0f), 1.0f / 2.2f); };
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      float most = 0.0f;
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(shown(a.texel(x, y)[c]) - shown(b.texel(x, y)[c])));
      count += most > steps ? 1 : 0;
    }
  return double(count) / (double(a.width()) * a.height());
}

/// Exact relief and the mesh that is cut along the same heights show the same, path by path.
TEST(ExactRelief, IsTheDisplacedMeshOnAPlane) {
  for (const View& view : {View{"plane", HeightKind::waves, 45.0f}, View{"plane", HeightKind::brick, 20.0f}}) {
    const Image exact = tracedRelief(view, ReliefKind::exact, sideLight(), {64, 48}, 4);
    const Image mesh = tracedRelief(view, ReliefKind::geometry, sideLight(), {64, 48}, 4);
    EXPECT_LT(shareThatDiffers(exact, mesh, 8.0f), 0.02) << view.elevation_deg;
    const Image flat = tracedRelief(view, ReliefKind::none, sideLight(), {64, 48}, 4);
    EXPECT_GT(shareThatDiffers(flat, mesh, 8.0f), 0.1) << view.elevation_deg;
  }
}

// What the renderer finds in steps the tracer finds exactly: it is the truth of each.
TEST(ExactRelief, StandsForAllKindsThatMoveTheSurface) {
  const View view{"plane", HeightKind::brick, 20.0f};
  const Image exact = tracedRelief(view, ReliefKind::exact, sideLight(), {32, 24}, 1);
  for (const ReliefKind kind : {ReliefKind::parallax, ReliefKind::occlusion, ReliefKind::cone})
    EXPECT_EQ(shareThatDiffers(tracedRelief(view, kind, sideLight(), {32, 24}, 1), exact, 0.0f), 0.0) << int(kind);
}

TEST(ExactRelief, IsTheDisplacedMeshOnASphere) {
  const View view{"sphere", HeightKind::waves, 20.0f};
  const Image exact = tracedRelief(view, ReliefKind::exact, sideLight(), {64, 48}, 4);
  const Image mesh = tracedRelief(view, ReliefKind::geometry, sideLight(), {64, 48}, 4);
  EXPECT_LT(shareThatDiffers(exact, mesh, 8.0f), 0.02);
}

/// A white surface in white light is white however often light goes to and fro in its joints.
TEST(ExactRelief, IsWhiteInTheFurnace) {
  Material material = matt(1.0f);
  material.height = HeightKind::brick;
  material.height_scale = 0.1f;
  material.height_frequency = 1.0f;
  Scene scene = shapeOf("sphere", material);
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  TraceSettings settings = small(16);
  settings.bounces = 128;
  settings.relief = ReliefKind::exact;
  const Image image = traced(std::move(scene), lightOf(1.0f), settings);
  expectWhite(image, 0.003, "brick");
}

/// Glass fills the relief, too, and nothing of white light is lost in it, however often waves reflect it totally.
TEST(ExactRelief, GlassIsWhiteInTheFurnaceAsTheDisplacedMeshIs) {
  Material material;
  material.base_color = glm::vec3(1.0f);  // each crossing tints
  material.transmission = 1.0f;
  material.perceptual_roughness = 0.0f;
  material.ior = 1.5f;
  material.height = HeightKind::waves;
  material.height_scale = 0.05f;
  material.height_frequency = 1.0f;
  for (const ReliefKind kind : {ReliefKind::geometry, ReliefKind::exact}) {
    Scene scene = shapeOf("sphere", material);
    ASSERT_TRUE(prepareRelief(scene, kind));
    TraceSettings settings = small(16);
    settings.bounces = 512;
    settings.relief = kind;
    expectWhite(traced(std::move(scene), lightOf(1.0f), settings), 1e-3, kind == ReliefKind::exact ? "exact" : "mesh");
  }
}

/// A ray from within a body meets its surface from below, but for one in hundreds near the bent sides of prisms.
TEST(ExactRelief, NoRayLeavesABodyUnseen) {
  Material material;
  material.transmission = 1.0f;
  material.height = HeightKind::waves;
  material.height_scale = 0.05f;
  material.height_frequency = 1.0f;
  Scene scene = shapeOf("sphere", material);
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  auto geometry = Geometry::make(scene);
  ASSERT_TRUE(geometry);
  ASSERT_TRUE(geometry->makeReliefs(scene));
  const BoundingSphere bounds = boundingSphere(scene);
  constexpr int kRays = 50000;
  int unseen = 0;
  std::mt19937 random;
  std::normal_distribution<float> spread;
  const auto direction = [&] { return glm::normalize(glm::vec3(spread(random), spread(random), spread(random))); };
  for (int i = 0; i < kRays; ++i) {
    const glm::vec3 origin = bounds.center + 0.9f * bounds.radius * direction();
    if (!geometry->hit(origin, direction(), 0.0f, Surfaces::reliefs)) ++unseen;
  }
  EXPECT_LT(unseen, kRays / 200);
}

/// Heights of exactly 1 and of 0, and no depth at all, leave no holes; a surface that is seen from both sides meets no
/// ray that has just left it.
TEST(ExactRelief, HasNoHoles) {
  for (const float height : {1.0f, 0.0f})
    for (const float scale : {0.01f, 0.0f})
      for (const bool is_double_sided : {false, true}) {
        Material material = matt(1.0f);
        material.height = HeightKind::map;
        material.height_texture = 0;
        material.height_scale = scale;
        material.double_sided = is_double_sided;
        Scene scene = shapeOf("sphere", material);
        scene.height_textures = {*heightTexture(Image(16, 16, 1, height), MapEdges::tiled)};
        ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
        TraceSettings settings = small(16);
        settings.bounces = 8;
        settings.relief = ReliefKind::exact;
        const Image image = traced(std::move(scene), lightOf(1.0f), settings);
        expectWhite(image, 0.003, std::to_string(height) + " of " + std::to_string(scale));
      }
}

TEST(ExactRelief, WhiteStaysWhiteFromBothSides) {
  Material material = matt(1.0f);
  material.height = HeightKind::waves;
  material.height_scale = 0.05f;
  material.height_frequency = 1.0f;
  material.double_sided = true;
  Scene scene = shapeOf("sphere", material);
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  TraceSettings settings = small(16);
  settings.bounces = 64;
  settings.relief = ReliefKind::exact;
  expectWhite(traced(std::move(scene), lightOf(1.0f), settings), 0.003, "waves");
}

TEST(ExactRelief, NoneAndBumpsLeaveTheSurfaceWhereItIs) {
  const View view{"plane", HeightKind::brick, 10.0f};
  const Environment light = sideLight();
  const Image none = tracedRelief(view, ReliefKind::none, light, {32, 24}, 4);
  const Image bump = tracedRelief(view, ReliefKind::bump, light, {32, 24}, 4);
  Material flat = matt(0.8f);
  Scene scene = shapeOf("plane", flat);
  const Camera camera =
      makeCamera({.azimuth_deg = 30.0f, .elevation_deg = 10.0f, .distance = 3.0f}, boundingSphere(scene), 4.0f / 3.0f);
  const auto tracer = PathTracer::make(std::move(scene), light);
  ASSERT_TRUE(tracer);
  const auto plain = tracer->render(camera, {.size = {32, 24}, .samples = 4, .bounces = 3});
  ASSERT_TRUE(plain);
  EXPECT_EQ(shareThatDiffers(none, plain->radiance, 0.0f), 0.0);
  EXPECT_GT(shareThatDiffers(bump, plain->radiance, 8.0f), 0.02);
}

}  // namespace
}  // namespace mirrorball
