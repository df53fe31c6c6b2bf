#include "mirrorball/scene/scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

TEST(StandUpright, TurnsZUpwardsAndLeavesXOnTheRight) {
  Scene scene = meshScene(cubeMesh());
  scene.instances[0].world_from_object = glm::translate(glm::mat4(1.0f), glm::vec3(1, 2, 3));
  standUpright(scene, UpAxis::y);
  EXPECT_EQ(glm::vec3(scene.instances[0].world_from_object[3]), glm::vec3(1, 2, 3));
  standUpright(scene, UpAxis::z);
  EXPECT_EQ(glm::vec3(scene.instances[0].world_from_object[3]), glm::vec3(1, 3, -2));
  EXPECT_EQ(glm::determinant(glm::mat3(scene.instances[0].world_from_object)), 1.0f) << "nothing is mirrored";
}

TEST(BoundingSphere, OfASphereIsExact) {
  const BoundingSphere bounds = boundingSphere(meshScene(sphereMesh(16, 32)));
  EXPECT_EQ(bounds.center, glm::vec3(0.0f));
  EXPECT_NEAR(bounds.radius, 1.0f, 1e-6f);
}

TEST(BoundingSphere, FollowsTheInstances) {
  Scene scene = meshScene(sphereMesh(16, 32));
  scene.instances[0].world_from_object =
      glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(3, 4, 5)), glm::vec3(2.0f));
  const BoundingSphere bounds = boundingSphere(scene);
  EXPECT_LT(glm::distance(bounds.center, glm::vec3(3, 4, 5)), 1e-6f);
  EXPECT_NEAR(bounds.radius, 2.0f, 1e-6f);
}

TEST(BoundingSphere, OfNothingIsTheUnitSphere) {
  const BoundingSphere bounds = boundingSphere(Scene{});
  EXPECT_EQ(bounds.center, glm::vec3(0.0f));
  EXPECT_EQ(bounds.radius, 1.0f);
}

TEST(BoundingSphere, OfAPointIsNotZero) {
  Mesh mesh;
  mesh.vertices.resize(3);
  for (Vertex& vertex : mesh.vertices) vertex.position = glm::vec3(7.0f);
  mesh.indices = {0, 1, 2};
  const BoundingSphere bounds = boundingSphere(meshScene(mesh));
  EXPECT_EQ(bounds.center, glm::vec3(7.0f));
  EXPECT_GT(bounds.radius, 0.0f);
}

}  // namespace
}  // namespace mirrorball
