// Our own tree beside Embree's: the same nearest surfaces.

#include "mirrorball/rays/ray_tree.h"

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/rays/geometry.h"
#include "mirrorball/rays/scene_occlusion.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

/// Rays of all directions through a scene, from within and from outside of its bounds.
class RandomRays {
 public:
  explicit RandomRays(const Scene& scene) : bounds_(boundingSphere(scene)) {}

  glm::vec3 direction() { return glm::normalize(glm::vec3(spread_(random_), spread_(random_), spread_(random_))); }
  glm::vec3 origin() { return bounds_.center + 1.5f * bounds_.radius * std::cbrt(share_(random_)) * direction(); }
  float radius() const { return bounds_.radius; }

 private:
  BoundingSphere bounds_;
  std::mt19937 random_;
  std::normal_distribution<float> spread_;
  std::uniform_real_distribution<float> share_{0.0f, 1.0f};
};

/// Tests that compare; skipped in a build without Embree, which has nothing to compare with.
class BothTrees : public ::testing::Test {
 protected:
  void SetUp() override {
    if (fastestRayTracer() != RayTracer::embree) GTEST_SKIP() << "this build has no Embree";
  }
};

/// How many of so many rays differ: only one meets something, or another place by more than rounding.
int differing(const Scene& scene, Surfaces surfaces, int rays) {
  auto embree = Geometry::make(scene, RayTracer::embree), own = Geometry::make(scene, RayTracer::own);
  EXPECT_TRUE(embree && own);
  if (surfaces == Surfaces::reliefs) {
    EXPECT_TRUE(embree->makeReliefs(scene));
    EXPECT_TRUE(own->makeReliefs(scene));
  }
  RandomRays random(scene);
  int differ = 0, met = 0;
  for (int i = 0; i < rays; ++i) {
    const glm::vec3 origin = random.origin(), direction = random.direction();
    const auto a = embree->hit(origin, direction, 0.0f, surfaces), b = own->hit(origin, direction, 0.0f, surfaces);
    if (a.has_value() != b.has_value()) ++differ;
    if (!a || !b) continue;
    ++met;
    const bool is_same = std::abs(a->distance - b->distance) <= 1e-4f * random.radius();
    if (!is_same) ++differ;
    if (!is_same || a->triangle != b->triangle || a->instance != b->instance) continue;  // at an edge either may be met
    EXPECT_LT(glm::distance(a->geometric_normal, b->geometric_normal), 1e-3f);
    EXPECT_LT(glm::distance(a->barycentric, b->barycentric), 2e-2f);
    EXPECT_EQ(a->relief.has_value(), b->relief.has_value());
  }
  EXPECT_GT(met, rays / 20);
  return differ;
}

Scene of(const std::string& name) { return *loadModel(name); }

TEST_F(BothTrees, MeetTheSame) {
  constexpr int kRays = 20000;
  for (const std::string name : {"sphere", "cube", "knot", "teapot", "plane"})
    EXPECT_LE(differing(of(name), Surfaces::triangles, kRays), kRays / 5000) << name;
}

TEST_F(BothTrees, MeetManyInstances) {
  Scene scene = of("cube");
  for (int i = 0; i < 50; ++i) {
    const glm::vec3 place(float(i % 5), float(i / 5 % 5), float(i / 25));
    const glm::mat4 placed = glm::rotate(glm::translate(glm::mat4(1.0f), 2.0f * place), float(i), glm::vec3(1.0f));
    scene.instances.push_back({0, glm::scale(placed, glm::vec3(1.0f, 0.5f, 1.0f + 0.02f * float(i)))});
  }
  EXPECT_LE(differing(scene, Surfaces::triangles, 20000), 4);
}

TEST_F(BothTrees, MeetReliefs) {
  Material material;
  material.height = HeightKind::waves;
  material.height_scale = 0.05f;
  material.height_frequency = 2.0f;
  Scene scene = of("sphere");
  for (Material& each : scene.materials) each = material;
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  EXPECT_LE(differing(scene, Surfaces::reliefs, 5000), 5);
}

TEST_F(BothTrees, FindTheSameOcclusion) {
  const auto openOf = [](RayTracer tracer) {
    Scene scene = of("knot");
    EXPECT_TRUE(findOcclusion(scene, *Geometry::make(scene, tracer), {.rays = 32}));
    std::vector<float> open;
    for (const VertexOcclusion& vertex : scene.instances[0].occlusion) open.push_back(vertex.open);
    return open;
  };
  const std::vector<float> by_embree = openOf(RayTracer::embree), by_own = openOf(RayTracer::own);
  ASSERT_EQ(by_embree.size(), by_own.size());
  double difference = 0.0;
  for (std::size_t i = 0; i < by_own.size(); ++i) difference += std::abs(double(by_embree[i]) - double(by_own[i]));
  EXPECT_LT(difference, 1e-3 * double(by_own.size()));
}

// A ray from within a closed body always meets it, also through corners and along edges, where rounding decides.
TEST(RayTree, NoRaySlipsBetweenTriangles) {
  for (const std::string name : {"sphere", "knot", "cube"}) {
    const Scene scene = of(name);
    const auto own = Geometry::make(scene, RayTracer::own);
    ASSERT_TRUE(own);
    const Mesh& mesh = scene.meshes[0];
    const glm::mat4& placed = scene.instances[0].world_from_object;
    // The tube's middle, not the knot's, is within the knot: by the normal of a vertex.
    const glm::vec3 inside =
        name == "knot"
            ? glm::vec3(placed * glm::vec4(mesh.vertices[0].position - 1e-3f * mesh.vertices[0].normal, 1.0f))
            : glm::vec3(0.01f, 0.02f, 0.03f);
    int slipped = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const auto corner = [&](std::size_t j) {
        return glm::vec3(placed * glm::vec4(mesh.vertices[mesh.indices[i + j]].position, 1.0f));
      };
      for (const glm::vec3 towards : {corner(0), (corner(0) + corner(1)) / 2.0f})
        if (towards != inside && !own->hit(inside, glm::normalize(towards - inside), 0.0f)) ++slipped;
    }
    EXPECT_EQ(slipped, 0) << name;
  }
}

// The fuzzer `transfer` found infinite normals: the squares of small areas are below the least float.
TEST(RayTree, TriangleOfAnySizeHasANormal) {
  for (const RayTracer tracer : {RayTracer::own, fastestRayTracer()})
    for (const float size : {1e-12f, 1e-9f, 1e-5f, 1.0f, 1e5f, 1e9f}) {
      Scene scene = of("plane");
      for (Instance& instance : scene.instances)
        for (int axis = 0; axis < 3; ++axis) instance.world_from_object[axis] *= size;
      const auto geometry = Geometry::make(scene, tracer);
      ASSERT_TRUE(geometry);
      const glm::vec3 towards = glm::normalize(glm::vec3(0.1f, -1.0f, 0.2f));
      const auto hit = geometry->hit(-0.2f * size * towards, towards, 0.0f);
      ASSERT_TRUE(hit) << int(tracer) << ", " << size;
      EXPECT_NEAR(glm::length(hit->geometric_normal), 1.0f, 1e-5f) << size;
      EXPECT_LT(glm::dot(hit->geometric_normal, towards), -0.9f) << size;
    }
}

TEST(RayTree, TakesWhatIsNotFiniteOrEmpty) {
  const auto nothing = Geometry::make({}, RayTracer::own);
  ASSERT_TRUE(nothing);
  EXPECT_FALSE(nothing->hit(glm::vec3(0.0f), {0.0f, 0.0f, 1.0f}, 0.0f));
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  Scene scene = of("cube");
  scene.meshes[0].edit().vertices[0].position.x = kNaN;
  scene.meshes[0].edit().vertices[1].position.x = std::numeric_limits<float>::max();
  const auto own = Geometry::make(scene, RayTracer::own);
  ASSERT_TRUE(own);
  EXPECT_TRUE(own->hit(glm::vec3(0.0f), {0.0f, 0.0f, 1.0f}, 0.0f) ||
              own->hit(glm::vec3(0.0f), {0.0f, 1.0f, 0.0f}, 0.0f));
  EXPECT_FALSE(own->hit(glm::vec3(kNaN), {0.0f, 0.0f, 1.0f}, 0.0f));
  EXPECT_FALSE(own->hit(glm::vec3(0.0f), glm::vec3(kNaN), 0.0f));
  // Along an axis.
  const auto along = Geometry::make(of("cube"), RayTracer::own)->hit({0.1f, 0.2f, 5.0f}, {0.0f, 0.0f, -1.0f}, 0.0f);
  ASSERT_TRUE(along);
  EXPECT_NEAR(along->distance, 5.0f - 1.0f / std::sqrt(3.0f), 1e-5f);
  EXPECT_LT(glm::distance(along->geometric_normal, glm::vec3(0.0f, 0.0f, 1.0f)), 1e-6f);
}

// Embree gives no barycentric coordinates of triangles as small as those of a model in micrometres.
TEST(RayTree, ModelsMayBeOfAnySize) {
  for (const RayTracer tracer : {fastestRayTracer(), RayTracer::own}) {
    const Scene scene = meshScene(sphereMesh(16, 32));
    const auto usual = Geometry::make(scene, tracer);
    ASSERT_TRUE(usual);
    for (const int power : {-40, -30, -20, 20, 30}) {
      Scene scaled = scene;
      for (Vertex& vertex : scaled.meshes[0].edit().vertices) vertex.position *= std::ldexp(1.0f, power);
      const auto geometry = Geometry::make(scaled, tracer);
      ASSERT_TRUE(geometry);
      RandomRays random(scene);
      for (int i = 0; i < 100; ++i) {
        const glm::vec3 origin = random.origin(), direction = random.direction();
        const auto hit = geometry->hit(std::ldexp(1.0f, power) * origin, direction, 0.0f, Surfaces::triangles);
        const auto right = usual->hit(origin, direction, 0.0f, Surfaces::triangles);
        ASSERT_EQ(hit.has_value(), right.has_value());
        if (!hit) continue;
        EXPECT_EQ(hit->triangle, right->triangle);
        EXPECT_LT(glm::distance(hit->barycentric, right->barycentric), 1e-5f) << power;
        EXPECT_LT(glm::distance(hit->geometric_normal, right->geometric_normal), 1e-5f) << power;
        EXPECT_NEAR(std::ldexp(hit->distance, -power), right->distance, 1e-6f) << power;
      }
    }
  }
}

}  // namespace
}  // namespace mirrorball
