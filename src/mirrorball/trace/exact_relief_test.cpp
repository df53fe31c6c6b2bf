// Exact relief beside the same bilinear patches as 8 x 8 pairs of triangles each, ray by ray: depth, normal and colour.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/rays/surface_point.h"
#include "mirrorball/scene/relief/displaced_mesh.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/trace/camera_rays.h"
#include "mirrorball/trace/path_tracer_testing.h"

namespace mirrorball {
namespace {

using namespace testing;

constexpr int kMapSide = 64;
constexpr int kTrianglesPerTexel = 8;
constexpr glm::ivec2 kPicture(320, 240);

/// What a pixel shows, each in [0, 1].
struct Seen {
  float depth = 1.0f;  ///< between the nearest and the farthest of the picture
  glm::vec3 normal{0.0f};
  float color = 0.0f;  ///< a matt surface under one lamp that relief may block
};

/// A scene with what shows it.
class Shown {
 public:
  Shown(Scene scene, ReliefKind kind)
      : scene_(std::move(scene)), kind_(kind), matrices_(normalMatrices(scene_)), geometry_(*Geometry::make(scene_)) {
    EXPECT_TRUE(geometry_.makeReliefs(scene_));
  }

  Seen along(const Ray& ray, float nearest, float farthest) const {
    const auto hit = frontHit(ray);
    if (!hit) return {};
    const glm::vec3 normal = surfacePointAt(scene_, matrices_[hit->instance], *hit, kind_).normal;
    return {(hit->distance - nearest) / (farthest - nearest), 0.5f + 0.5f * normal, colorOf(ray, *hit, normal)};
  }

 private:
  /// Beyond the edges of a base a ray may see its triangles from below. Relief is seen from above.
  std::optional<Hit> frontHit(const Ray& ray) const {
    float passed = 0.0f;
    for (;;) {
      const auto hit = geometry_.hit(ray.origin, ray.direction, passed, Surfaces::reliefs);
      if (!hit || glm::dot(hit->geometric_normal, ray.direction) < 0.0f) return hit;
      passed = hit->distance + 1e-5f;
    }
  }

  float colorOf(const Ray& ray, const Hit& hit, glm::vec3 normal) const {
    static const glm::vec3 lamp = glm::normalize(glm::vec3(0.4f, 0.8f, 0.3f));
    const glm::vec3 place = hit.relief ? hit.relief->position : ray.origin + hit.distance * ray.direction;
    const auto blocked = geometry_.hit(place + 1e-4f * hit.geometric_normal, lamp, 1e-4f, Surfaces::reliefs);
    return blocked ? 0.0f : std::max(glm::dot(normal, lamp), 0.0f);
  }

  Scene scene_;
  ReliefKind kind_;
  std::vector<glm::mat3> matrices_;
  Geometry geometry_;
};

Scene reliefOf(const char* shape, HeightKind height, float scale) {
  Material material = matt(0.8f);
  material.height = HeightKind::map;
  material.height_texture = 0;
  material.height_scale = scale;
  material.height_frequency = 1.0f;
  Scene scene = shapeOf(shape, material);
  scene.height_textures = {*heightTexture(builtinHeights(height, kMapSide), MapEdges::tiled)};
  return scene;
}

struct Shares {
  double depth = 0.0;
  double normal = 0.0;
  double color = 0.0;
};

/// The shares of the pixels that differ by more than 2/255.
Shares sharesThatDiffer(const char* shape, HeightKind height, float scale, float elevation_deg) {
  Scene scene = reliefOf(shape, height, scale);
  const BoundingSphere bounds = boundingSphere(scene);
  const Camera camera = makeCamera({.azimuth_deg = 30.0f, .elevation_deg = elevation_deg, .distance = 3.0f}, bounds,
                                   float(kPicture.x) / float(kPicture.y));
  Scene cut = scene;
  EXPECT_TRUE(displaceMeshes(cut, {.texels_per_triangle = 1.0f / float(kTrianglesPerTexel)}));
  EXPECT_TRUE(cut.warnings.empty());
  const Shown exact(std::move(scene), ReliefKind::exact);
  const Shown triangles(std::move(cut), ReliefKind::geometry);
  const CameraRays rays = raysOf(camera, kPicture, {});
  const float to_center = glm::length(camera.position - bounds.center);
  const float nearest = to_center - bounds.radius;
  const float farthest = to_center + bounds.radius;
  Shares shares;
  const double pixel = 1.0 / (double(kPicture.x) * kPicture.y);
  const auto differs = [](float off) { return off > 2.0f / 255.0f; };
  for (int y = 0; y < kPicture.y; ++y)
    for (int x = 0; x < kPicture.x; ++x) {
      const auto ray = rays(glm::vec2(x, y) + 0.5f);
      const Seen a = exact.along(*ray, nearest, farthest);
      const Seen b = triangles.along(*ray, nearest, farthest);
      const glm::vec3 turned = glm::abs(a.normal - b.normal);
      shares.depth += differs(std::abs(a.depth - b.depth)) ? pixel : 0.0;
      shares.normal += differs(std::max({turned.x, turned.y, turned.z})) ? pixel : 0.0;
      shares.color += differs(std::abs(a.color - b.color)) ? pixel : 0.0;
    }
  return shares;
}

/// Colour has a share of its own: where a lamp grazes the relief, little decides whether it is blocked.
void expectSame(const char* shape, HeightKind height, float elevation_deg, double share, double share_of_color) {
  const Shares shares = sharesThatDiffer(shape, height, 0.1f, elevation_deg);
  const std::string what = std::string(builtinHeightNames()[std::size_t(height) - 1]) + " on the " + shape + " at " +
                           std::to_string(elevation_deg);
  EXPECT_LE(shares.depth, share) << what;
  EXPECT_LE(shares.normal, share) << what;
  EXPECT_LE(shares.color, share_of_color) << what;
}

TEST(ExactReliefBesideTriangles, OnAFlatBase) {
  for (const HeightKind height : {HeightKind::orange, HeightKind::brick, HeightKind::cobbles, HeightKind::weave,
                                  HeightKind::hammered, HeightKind::waves})
    for (const float elevation : {45.0f, 15.0f, 5.0f}) expectSame("plane", height, elevation, 1e-4, 1e-4);
}

TEST(ExactReliefBesideTriangles, OnCurvedMeshes) {
  for (const char* shape : {"sphere", "torus"})
    for (const HeightKind height : {HeightKind::brick, HeightKind::waves}) expectSame(shape, height, 20.0f, 8e-4, 6e-3);
}

/// A model's geometry, with reliefs.
Geometry reliefGeometry(const Scene& scene) {
  Geometry geometry = *Geometry::make(scene);
  EXPECT_TRUE(geometry.makeReliefs(scene));
  return geometry;
}

// A ray meets what it meets if it is looked for in whole prisms, and not between the heights alone that a prism has.
void expectNothingIsHidden(const char* shape, HeightKind height, bool is_double_sided) {
  Scene scene = reliefOf(shape, height, 0.1f);
  scene.materials[0].height_frequency = 3.0f;
  scene.materials[0].double_sided = is_double_sided;
  const BoundingSphere bounds = boundingSphere(scene);
  const Camera camera =
      makeCamera({.azimuth_deg = 30.0f, .elevation_deg = 20.0f, .distance = 3.0f}, bounds, 4.0f / 3.0f);
  Scene unbounded = scene;
  unbounded.height_textures[0].edit().bounds = {};
  const Geometry bounded = reliefGeometry(scene), whole = reliefGeometry(unbounded);
  const glm::ivec2 size(120, 90);
  const CameraRays rays = raysOf(camera, size, {});
  int met = 0, missed = 0, elsewhere = 0;
  for (int i = 0; i < size.x * size.y; ++i) {
    const auto ray = rays(glm::vec2(i % size.x, i / size.x) + 0.5f);
    const auto a = bounded.hit(ray->origin, ray->direction, 0.0f, Surfaces::reliefs);
    const auto b = whole.hit(ray->origin, ray->direction, 0.0f, Surfaces::reliefs);
    if (!b) continue;
    ++met;
    if (!a) ++missed;
    // Bent rays are cut into shorter pieces in a slab, and so meet the surface more exactly: that is not a miss.
    if (a && std::abs(a->distance - b->distance) > 1e-3f * bounds.radius) ++elsewhere;
  }
  EXPECT_GT(met, 2000);
  EXPECT_EQ(missed, 0) << shape << ", " << int(height) << ", " << is_double_sided;
  EXPECT_LE(elsewhere, met / 400) << shape << ", " << int(height) << ", " << is_double_sided;
}

TEST(ExactReliefBesideTriangles, BoundsOfPrismsHideNothing) {
  for (const char* shape : {"sphere", "torus"})
    for (const HeightKind height : {HeightKind::cobbles, HeightKind::waves})
      for (const bool is_double_sided : {false, true}) expectNothingIsHidden(shape, height, is_double_sided);
}

}  // namespace
}  // namespace mirrorball
