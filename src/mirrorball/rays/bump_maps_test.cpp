// Bumps of heights, by normals in tangent or object space, and by slopes: the same normals as the renderer's
// (render/frame/bump_maps_test.cpp).

#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/rays/geometry.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/scene/bumpy_pair_testing.h"

namespace mirrorball {
namespace {

using testing::BumpForm;

/// The normal that a ray from +Z finds at a place of the plane z = 0.
glm::vec3 normalAt(const Scene& scene, glm::vec2 place, ReliefKind relief = ReliefKind::bump) {
  const auto geometry = Geometry::make(scene);
  EXPECT_TRUE(geometry);
  const auto hit = geometry->hit({place, 2.0f}, {0, 0, -1}, 0.0f);
  EXPECT_TRUE(hit);
  return surfacePointAt(scene, normalMatrices(scene)[0], *hit, relief).normal;
}

TEST(BumpMaps, HeightsNormalsAndSlopesBendTheSameNormals) {
  for (const BumpForm form : testing::kEveryBumpForm) {
    const Scene scene = testing::bumpyPair(form, {});
    for (float x = -0.95f; x < 1.0f; x += 0.17f)
      for (float y = -0.45f; y < 0.5f; y += 0.23f)
        EXPECT_LT(glm::distance(normalAt(scene, {x, y}), testing::normalOfPair({x, y})), testing::toleranceOf(form))
            << testing::nameOf(form) << " at (" << x << ", " << y << ")";
  }
}

TEST(BumpMaps, ObjectSpaceTurnsWithItsInstance) {
  Material material;
  material.normal_map.texture = 0;
  material.normal_space = NormalSpace::object;
  Scene scene = meshScene(testing::mirroredPair(), material);
  Image normals(1, 1, 3);
  normals.texel(0, 0)[0] = 0.6f;
  normals.texel(0, 0)[2] = 0.8f;
  scene.textures.push_back(testing::textureOfNormals(normals));
  EXPECT_LT(glm::distance(normalAt(scene, {0.3f, 0.1f}), glm::vec3(0.6f, 0.0f, 0.8f)), 0.008f);
  glm::mat4& placed = scene.instances[0].world_from_object;
  placed = glm::rotate(glm::mat4(1.0f), glm::half_pi<float>(), glm::vec3(0, 0, 1));
  EXPECT_LT(glm::distance(normalAt(scene, {0.3f, 0.1f}), glm::vec3(0.0f, 0.6f, 0.8f)), 0.008f);
  scene.materials[0].normal_scale = 0.0f;
  EXPECT_LT(glm::distance(normalAt(scene, {0.3f, 0.1f}), glm::vec3(0.0f, 0.0f, 1.0f)), 1e-6f);
}

TEST(BumpMaps, SlopesGiveWayToHeightsAndNeedCoordinates) {
  Scene both = testing::bumpyPair(BumpForm::heights, {});
  const glm::vec3 of_heights = normalAt(both, {0.3f, 0.1f});
  both.materials[0].slope_texture = 0;
  both.slope_textures.push_back(Image(1, 1, 3));
  both.slope_textures[0].edit().texel(0, 0)[2] = 0.75f;
  EXPECT_EQ(normalAt(both, {0.3f, 0.1f}), of_heights);
  EXPECT_LT(glm::distance(normalAt(both, {0.3f, 0.1f}, ReliefKind::none), glm::vec3(0.0f, 0.6f, 0.8f)), 1e-5f);
  for (Vertex& vertex : both.meshes[0].edit().vertices) vertex.uv[0] = glm::vec2(0.0f);
  EXPECT_EQ(normalAt(both, {0.3f, 0.1f}, ReliefKind::none), glm::vec3(0.0f, 0.0f, 1.0f));
}

}  // namespace
}  // namespace mirrorball
