#include "mirrorball/scene/shapes/interreflection.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mirrorball/scene/mesh_testing.h"

namespace mirrorball {
namespace {

using testing::expectEdgesPaired;
using testing::expectSound;
using testing::expectTangentsAlongU;
using testing::expectUnitBounds;
using testing::signedVolume;

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
  ASSERT_EQ(scene.meshes.size(), 1u) << "a body is one mesh";
  const Mesh& bowl = scene.meshes[0];
  expectSound(bowl, 0.999f);
  expectTangentsAlongU(bowl, 0.999f);
  expectEdgesPaired(bowl);
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
  const Mesh& bowl = scene.meshes[0];
  const TextureSlot& slot = scene.materials[0].occlusion_map;
  ASSERT_EQ(slot.texture, 0);
  ASSERT_EQ(slot.uv_set, 1);
  // By Archimedes the inner sphere's area without the cap is 2π r (r + h); its triangles' is that.
  double area = 0.0;
  for (std::size_t i = 0; i < bowl.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) -> const Vertex& { return bowl.vertices[bowl.indices[i + k]]; };
    const auto at = [&](std::size_t k) { return glm::dvec3(corner(k).position); };
    const bool is_inside = corner(0).uv[1].y == 0.25f;
    ASSERT_EQ(is_inside, corner(1).uv[1].y == 0.25f);
    ASSERT_EQ(is_inside, corner(2).uv[1].y == 0.25f);
    if (is_inside) area += glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2.0;
  }
  const double open = 1.0 - area / (4.0 * std::numbers::pi * 0.9 * 0.9);
  EXPECT_NEAR(scene.textures[0].image.texel(0, 0)[0] / 255.0, open, 1e-3);
  EXPECT_EQ(scene.textures[0].image.texel(0, 1)[0], 255) << "nothing blocks the outside";
}

}  // namespace
}  // namespace mirrorball
