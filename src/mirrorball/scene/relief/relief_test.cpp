#include "mirrorball/scene/relief/relief.h"

#include <gtest/gtest.h>

#include "mirrorball/scene/relief/relief_surface.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

Scene planeOf(HeightKind kind, float scale) {
  Material material;
  material.height = kind;
  material.height_scale = scale;
  material.height_frequency = 1.0f;
  return sceneOf(planeMesh(), material);
}

TEST(PrepareRelief, TurnsHeightsOverWhereTheScaleIsBelowZero) {
  Scene scene = planeOf(HeightKind::brick, -0.1f);
  scene.materials.push_back(planeOf(HeightKind::brick, 0.1f).materials[0]);
  scene.materials.push_back(scene.materials[0]);
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  ASSERT_EQ(scene.height_textures.size(), 2u);
  EXPECT_EQ(scene.materials[0].height_texture, scene.materials[2].height_texture);
  for (const Material& material : scene.materials) EXPECT_EQ(material.height_scale, 0.1f);
  const Image& over = scene.height_textures[std::size_t(scene.materials[0].height_texture)].heights;
  const Image& upright = scene.height_textures[std::size_t(scene.materials[1].height_texture)].heights;
  for (int x = 0; x < over.width(); ++x) EXPECT_EQ(over.texel(x, 77)[0], 1.0f - upright.texel(x, 77)[0]) << x;
  // The last level bounds all.
  const HeightTexture& texture = scene.height_textures[std::size_t(scene.materials[0].height_texture)];
  const glm::ivec2 last = formula::placeOfLevel(heightMapOf(texture), 9);
  EXPECT_GT(texture.picture.texel(last.x, last.y)[0], 0.9f);
}

TEST(PrepareRelief, ChangesNothingTheSecondTime) {
  Scene scene = planeOf(HeightKind::waves, -0.1f);
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  const float height = scene.height_textures[0].heights.texel(3, 4)[0];
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  EXPECT_EQ(scene.height_textures.size(), 1u);
  EXPECT_EQ(scene.height_textures[0].heights.texel(3, 4)[0], height);
}

TEST(PrepareRelief, GivesTexturesOnlyToWhatReadsThem) {
  for (const ReliefKind kind : {ReliefKind::none, ReliefKind::bump}) {
    Scene scene = planeOf(HeightKind::orange, -0.1f);
    ASSERT_TRUE(prepareRelief(scene, kind));
    EXPECT_TRUE(scene.height_textures.empty());
    EXPECT_EQ(scene.materials[0].height_scale, -0.1f);
  }
  Scene without_map = planeOf(HeightKind::map, 0.1f);
  ASSERT_TRUE(prepareRelief(without_map, ReliefKind::exact));
  EXPECT_TRUE(without_map.height_textures.empty());
  Scene bumps = planeOf(HeightKind::weave, 0.1f);
  ASSERT_TRUE(prepareRelief(bumps, ReliefKind::bump));
  EXPECT_EQ(bumps.height_textures.size(), 1u);
}

TEST(PrepareRelief, WarnsWhereHeightsLieOverCoordinatesThatAMeshDoesNotHave) {
  const auto warningsOf = [](HeightKind height, ReliefKind kind) {
    Scene scene = planeOf(height, 0.1f);
    for (Vertex& vertex : scene.meshes[0].vertices) vertex.uv[0] = glm::vec2(0.0f);
    EXPECT_TRUE(prepareRelief(scene, kind));
    return scene.warnings.size();
  };
  EXPECT_EQ(warningsOf(HeightKind::orange, ReliefKind::bump), 0u) << "a function of the place";
  EXPECT_EQ(warningsOf(HeightKind::orange, ReliefKind::exact), 1u) << "a tile like the others";
  EXPECT_EQ(warningsOf(HeightKind::brick, ReliefKind::bump), 1u);
  EXPECT_EQ(warningsOf(HeightKind::brick, ReliefKind::none), 0u);
}

TEST(ReliefNormal, LeansAwayFromTheWayUp) {
  Image heights(4, 1, 1);
  for (int x = 0; x < 4; ++x) heights.texel(x, 0)[0] = 0.25f * static_cast<float>(x);
  const auto texture = heightTexture(std::move(heights), MapEdges::clamped);
  ASSERT_TRUE(texture);
  const Mesh plane = planeMesh();
  Material material;
  material.height_scale = 0.5f;
  material.height_frequency = 1.0f;
  const formula::ReliefPrism prism = reliefPrism(plane, 0, material, *texture);
  // The middle of the plane: over its side √2 the heights would rise by 1, so the surface by 0.5.
  const Vertex& a = plane.vertices[plane.indices[0]];
  const glm::vec3 along_u = glm::normalize(glm::vec3(a.tangent));
  const glm::vec3 expected = glm::normalize(a.normal - 0.5f / std::sqrt(2.0f) * along_u);
  const glm::vec3 normal = reliefNormal(*texture, prism, material.height_scale, {0.5f, 0.0f});
  const glm::vec3 middle = reliefNormal(*texture, prism, material.height_scale, {0.0f, 0.5f});
  const bool x_is_diagonal = prism.texel_along_x.x != 0.0f && prism.texel_along_x.y != 0.0f;
  EXPECT_LT(glm::distance(x_is_diagonal ? normal : middle, expected), 1e-5f);
}

}  // namespace
}  // namespace mirrorball
