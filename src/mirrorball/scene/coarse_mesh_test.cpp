#include "mirrorball/scene/coarse_mesh.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "mirrorball/scene/scene.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

TEST(CoarseMesh, HasTheShapeOfTheMesh) {
  const CoarseMesh coarse = coarseMesh(sphereMesh(), 3000);
  EXPECT_LE(coarse.indices.size() / 3, 3000u);
  EXPECT_GT(coarse.indices.size() / 3, 500u);
  for (const std::uint32_t index : coarse.indices) ASSERT_LT(index, coarse.positions.size());
  Box box;
  for (const glm::vec3& position : coarse.positions) {
    EXPECT_NEAR(glm::length(position), 1.0f, 1e-4f);
    box.include({position, position});
  }
  EXPECT_NEAR(glm::distance(box.low, glm::vec3(-1.0f)), 0.0f, 0.05f);
  EXPECT_NEAR(glm::distance(box.high, glm::vec3(1.0f)), 0.0f, 0.05f);
}

TEST(CoarseMesh, LeavesFewTrianglesAsTheyAre) {
  const Mesh cube = cubeMesh();
  EXPECT_EQ(coarseMesh(cube, 1000).indices.size(), cube.indices.size());
  EXPECT_TRUE(coarseMesh(Mesh(), 10).indices.empty());
}

}  // namespace
}  // namespace mirrorball
