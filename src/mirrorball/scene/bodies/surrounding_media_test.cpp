#include "mirrorball/scene/bodies/surrounding_media.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/scene/mesh_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/tumbler.h"

namespace mirrorball {
namespace {

using testing::glassOf;

formula::Media mediaIn(const Scene& scene, glm::vec3 point) {
  const auto tree = bodyTree(scene);
  EXPECT_TRUE(tree && *tree);
  return surroundingMedia(scene, point, **tree);
}

/// How many bodies a place lies in.
int depthIn(const formula::Media& media) {
  int depth = 0;
  for (const glm::uvec4& words : {media.latest, media.earliest})
    for (int i = 0; i < 4; ++i) depth += words[i] != 0u ? 1 : 0;
  return depth;
}

TEST(SurroundingMedia, AreThoseBodiesThatAPointLiesIn) {
  Scene scene = glassOf(torusMesh(48, 24));
  // A ball in the tube of the torus, and one around all.
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].priority = 3;
  for (const float scale : {0.1f, 4.0f}) {
    Mesh ball = sphereMesh(24, 48);
    ball.material = 1;
    const glm::vec3 place = scale < 1.0f ? glm::vec3(0.7f, 0.0f, 0.0f) : glm::vec3(0.0f);
    scene.instances.push_back(
        {static_cast<int>(scene.meshes.size()), glm::scale(glm::translate(glm::mat4(1.0f), place), glm::vec3(scale))});
    scene.meshes.push_back(std::move(ball));
  }
  const glm::vec3 in_small_ball(scene.instances[1].world_from_object[3]);
  const formula::Media innermost = mediaIn(scene, in_small_ball);
  EXPECT_EQ(depthIn(innermost), 3);
  for (const int body : {0, 1, 2}) EXPECT_EQ(formula::timesEntered(innermost, body), 1) << body;
  EXPECT_EQ(int(innermost.latest.z >> formula::kPriorityShift) - formula::kGreatestPriority - 1, 3)
      << "of the outermost";
  const formula::Media in_hole = mediaIn(scene, glm::vec3(0.0f));
  EXPECT_EQ(depthIn(in_hole), 1);
  EXPECT_EQ(formula::fillingBody(in_hole), 2);
  EXPECT_EQ(depthIn(mediaIn(scene, glm::vec3(0.0f, 5.0f, 0.0f))), 0);
}

// The water's sides and bottom lie in the glass, its surface in air, though its edge is in the middle of the wall.
TEST(IorAround, WaterLiesInItsGlassAndInAir) {
  const Scene scene = tumblerWaterScene();
  const auto tree = bodyTree(scene);
  ASSERT_TRUE(tree && *tree);
  const std::vector<float> around = iorAround(scene, 1, **tree);
  const Mesh& water = scene.meshes[1];
  ASSERT_EQ(around.size(), water.vertices.size());
  for (const std::uint32_t i : water.indices) {
    const bool is_top = water.vertices[i].normal.y > 0.9f;
    ASSERT_EQ(around[i], is_top ? 1.0f : scene.materials[0].ior) << i;
  }
}

// What an open mesh would enclose is not known from its triangles.
TEST(SurroundingMedia, AnOpenSheetSurroundsNothing) {
  const Scene sheet = glassOf(planeMesh());
  for (const float side : {-0.1f, 0.1f}) {
    EXPECT_EQ(depthIn(mediaIn(sheet, {0.0f, side, 0.0f})), 0);
    EXPECT_EQ(depthIn(mediaIn(sheet, {0.0f, 0.0f, side})), 0);
  }
}

}  // namespace
}  // namespace mirrorball
