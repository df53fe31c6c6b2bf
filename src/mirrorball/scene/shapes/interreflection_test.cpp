#include "mirrorball/scene/shapes/interreflection.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mirrorball/scene/mesh_testing.h"

namespace mirrorball {
namespace {

using testing::expectSound;
using testing::expectTangentsAlongU;
using testing::openEdgeCount;
using testing::signedVolume;

void expectUnitBounds(const Scene& scene) {
  const BoundingSphere bounds = boundingSphere(scene);
  EXPECT_LT(glm::length(bounds.center), 1e-5f);
  EXPECT_NEAR(bounds.radius, 1.0f, 1e-5f);
}

/// All meshes of a scene as one.
Mesh joined(const Scene& scene) {
  Mesh all;
  for (const Mesh& mesh : scene.meshes) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const std::uint32_t index : mesh.indices) all.indices.push_back(first + index);
  }
  return all;
}

TEST(SpheresScene, AreTwoMirrorsAGapApart) {
  for (const float gap : {0.0f, 0.25f, 3.0f}) {
    const Scene scene = spheresScene(gap);
    expectUnitBounds(scene);
    ASSERT_EQ(scene.instances.size(), 2u);
    const glm::mat4& left = scene.instances[0].world_from_object;
    const float radius = glm::length(glm::vec3(left[0]));
    EXPECT_NEAR(glm::distance(left[3], scene.instances[1].world_from_object[3]), (2.0f + gap) * radius, 1e-5f);
    EXPECT_EQ(scene.materials[0].perceptual_roughness, 0.0f);
  }
}

TEST(BowlScene, IsAClosedBodyWithItsVolume) {
  const Scene scene = bowlScene();
  expectUnitBounds(scene);
  for (const Mesh& mesh : scene.meshes) {
    expectSound(mesh, 0.999f);
    expectTangentsAlongU(mesh, 0.999f);
  }
  const Mesh bowl = joined(scene);
  EXPECT_EQ(openEdgeCount(bowl), 0u);
  // Of a ball of radius r, what is below the height h: π (2/3 r³ + r² h − h³/3).
  const auto below = [](double r, double h) {
    return std::numbers::pi * (2.0 / 3.0 * r * r * r + r * r * h - h * h * h / 3.0);
  };
  const double height = 0.9 * (1.0 - 2.0 * double(kBowlOpenShare));
  const double exact = below(1.0, height) - below(0.9, height);
  EXPECT_NEAR(signedVolume(bowl), exact, 2e-3 * exact);
}

TEST(BowlScene, TheMapHoldsTheMissingCapsShareOfTheSphere) {
  const Scene scene = bowlScene();
  const Mesh& inside = scene.meshes[1];
  const Material& material = scene.materials[std::size_t(inside.material)];
  ASSERT_EQ(material.occlusion_map.texture, 0);
  // By Archimedes the inner sphere's area without the cap is 2π r (r + h); its triangles' is that.
  double area = 0.0;
  for (std::size_t i = 0; i < inside.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(inside.vertices[inside.indices[i + k]].position); };
    area += glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2.0;
  }
  const double open = 1.0 - area / (4.0 * std::numbers::pi * 0.9 * 0.9);
  EXPECT_NEAR(scene.textures[0].image.texel(0, 0)[0] / 255.0, open, 1e-3);
  EXPECT_LT(scene.materials[0].occlusion_map.texture, 0) << "nothing blocks the outside";
}

}  // namespace
}  // namespace mirrorball
