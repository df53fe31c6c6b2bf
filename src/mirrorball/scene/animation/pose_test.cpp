// Nodes that are placed by hand, of scenes that were made or changed by code.

#include "mirrorball/scene/animation/pose.h"

#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/scene/box.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

Scene ballAt(glm::vec3 place) {
  Scene scene = meshScene(sphereMesh(8, 16));
  scene.instances[0].world_from_object = glm::translate(glm::mat4(1.0f), place);
  return scene;
}

glm::vec3 placeOf(const Scene& scene, std::size_t instance) {
  return glm::vec3(scene.instances.at(instance).world_from_object[3]);
}

TEST(Nodes, OfASceneThatStandsUprightAreWhereItIs) {
  Scene scene = ballAt({0, 0, 1});
  standUpright(scene, UpAxis::z);
  addNodes(scene);
  ASSERT_TRUE(placeNode(scene, 0, NodePlace(scene.rig.nodes[0].place)));
  EXPECT_EQ(placeOf(scene, 0), glm::vec3(0, 1, 0));
  EXPECT_EQ(scene.instances[0].node, 0);
}

TEST(Nodes, CarryCamerasAndLampsOfAnyDirection) {
  Scene scene = ballAt({0, 0, 0});
  scene.cameras.push_back({.name = "eye", .world_from_view = glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, 5))});
  scene.lights.resize(2);
  scene.lights[0].direction = {0, -1, 0};
  scene.lights[1].direction = {0, 0, 0};
  addNodes(scene);
  ASSERT_TRUE(placeNode(scene, 1, {.translation = {1, 0, 0}}));
  EXPECT_EQ(glm::vec3(scene.cameras[0].world_from_view[3]), glm::vec3(1, 0, 0));
  EXPECT_LT(glm::distance(scene.lights[0].direction, glm::vec3(0, -1, 0)), 1e-6f);
  scene.lights.clear();
  EXPECT_TRUE(placeNode(scene, 0, {})) << "of lamps that are not there any more nothing is said";
}

TEST(Nodes, AMirrorImageIsOfTheMeshAsItIs) {
  Scene scene = ballAt({0, 0, 0});
  addNodes(scene);
  const NodePlace mirrored{.scale = {-1, 1, 1}};
  ASSERT_TRUE(placeNode(scene, 0, mirrored));
  ASSERT_TRUE(placeNode(scene, 0, {}));
  for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.position.y *= 2.0f;
  ASSERT_TRUE(placeNode(scene, 0, mirrored));
  EXPECT_EQ(boundingBox(scene).high.y, 2.0f);
  scene.meshes.resize(1);
  ASSERT_TRUE(placeNode(scene, 0, mirrored));
  EXPECT_LT(std::size_t(scene.instances[0].mesh), scene.meshes.size());
}

}  // namespace
}  // namespace mirrorball
