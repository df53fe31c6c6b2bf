#include "mirrorball/transfer/simplify.h"

#include <set>
#include <tuple>

#include "mirrorball/scene/mesh_testing.h"
#include "mirrorball/transfer/transfer_testing.h"

namespace mirrorball {
namespace {

TEST(Simplified, SphereIsClosedNearAndHasNoMoreTriangles) {
  const Scene dense = meshScene(sphereMesh(64, 128));
  for (const std::size_t triangles : {std::size_t{2000}, std::size_t{500}, std::size_t{100}}) {
    const auto light = simplified(dense, triangles);
    ASSERT_TRUE(light) << light.error().message;
    EXPECT_LE(light->mesh.indices.size(), 3 * triangles);
    EXPECT_GT(light->mesh.indices.size(), 3 * triangles * 9 / 10);
    EXPECT_EQ(testing::openEdgeCount(light->mesh), 0u);
    for (const Vertex& vertex : light->mesh.vertices) {
      EXPECT_NEAR(glm::length(vertex.position), 1.0f, 1e-5f);  // vertices are some of the dense one's
      EXPECT_GT(glm::dot(vertex.normal, vertex.position), 0.8f);
    }
    EXPECT_GT(testing::signedVolume(light->mesh), triangles < 200 ? 3.5 : 4.0);  // 4.19 of the sphere
  }
}

TEST(Simplified, ModelOfManyPartsIsJoinedWhereTheyAre) {
  Scene two = meshScene(sphereMesh(16, 32));
  two.instances.push_back({0, glm::mat4(1.0f)});
  two.instances[1].world_from_object[3] = {10, 0, 0, 1};
  const auto light = simplified(two, 200);
  ASSERT_TRUE(light);
  EXPECT_LE(light->mesh.indices.size(), 600u);
  const BoundingSphere bounds = boundingSphere(meshScene(light->mesh));
  EXPECT_NEAR(bounds.center.x, 5.0f, 0.1f);
  EXPECT_NEAR(bounds.radius, 6.0f, 0.1f);
}

TEST(Simplified, LeavesWhatIsLightAlready) {
  const auto cube = simplified(meshScene(cubeMesh()), 100);
  ASSERT_TRUE(cube);
  EXPECT_EQ(cube->mesh.indices.size(), 36u);
  EXPECT_EQ(cube->mesh.vertices.size(), 8u);  // one a place
  EXPECT_EQ(cube->error, 0.0f);
}

TEST(Simplified, OfOneTriangleIsItAndOfNoneAnError) {
  Mesh triangle = testing::flatPlate();
  triangle.indices.resize(3);
  const auto one = simplified(meshScene(triangle), 1);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->mesh.indices.size(), 3u);
  EXPECT_EQ(one->mesh.vertices.size(), 3u);

  EXPECT_FALSE(simplified(Scene(), 1));
  for (Vertex& vertex : triangle.vertices) vertex.position = glm::vec3(1.0f);
  EXPECT_FALSE(simplified(meshScene(triangle), 1));
}

}  // namespace
}  // namespace mirrorball
