#include "mirrorball/scene/shapes/builtin_shapes.h"

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

TEST(SphereMesh, IsARoundClosedUnitSphere) {
  const Mesh mesh = sphereMesh();
  expectUnitBounds(meshScene(mesh));
  expectSound(mesh, 0.999f);
  expectEdgesPaired(mesh);
  // The volume that 128 rings of 256 segments lack of the ball's falls with the square of the step.
  EXPECT_NEAR(signedVolume(mesh), 4.0 / 3.0 * std::numbers::pi, 2e-3);
  for (const Vertex& vertex : mesh.vertices) ASSERT_EQ(vertex.normal, vertex.position);
}

TEST(SphereMesh, HasPlusZInTheMiddleOfItsTextureAndPlusXToTheRight) {
  for (const Vertex& vertex : sphereMesh(4, 8).vertices) {
    const auto expect_at = [&](glm::vec3 place) { EXPECT_LT(glm::distance(vertex.position, place), 1e-6f); };
    if (vertex.uv[0] == glm::vec2(0.5f, 0.5f)) expect_at({0, 0, 1});
    if (vertex.uv[0] == glm::vec2(0.75f, 0.5f)) expect_at({1, 0, 0});
    if (vertex.uv[0].y == 0.0f) expect_at({0, 1, 0});
  }
}

TEST(SphereMesh, OfTheFewestRingsIsClosed) {
  const Mesh mesh = sphereMesh(2, 3);
  expectEdgesPaired(mesh);
  EXPECT_EQ(mesh.indices.size(), 3u * 6u);
}

TEST(TorusMesh, HasItsVolume) {
  const Mesh mesh = torusMesh();
  expectUnitBounds(meshScene(mesh));
  expectSound(mesh, 0.999f);
  expectTangentsAlongU(mesh, 0.999f);
  expectEdgesPaired(mesh);
  const double exact = 2.0 * std::numbers::pi * std::numbers::pi * 0.7 * 0.3 * 0.3;
  EXPECT_NEAR(signedVolume(mesh), exact, 2e-3 * exact);
}

TEST(KnotMesh, IsAClosedTubeWithoutASeam) {
  const Mesh mesh = knotMesh();
  expectUnitBounds(meshScene(mesh));
  expectSound(mesh, 0.99f);
  expectTangentsAlongU(mesh, 0.999f);
  expectEdgesPaired(mesh);
  EXPECT_GT(signedVolume(mesh), 0.0);
}

TEST(KnotMesh, IsTheTrefoilInItsTubesMiddle) {
  constexpr int kSides = 48;
  const Mesh mesh = knotMesh(480, kSides);
  // Opposite points of the tube give its middle; on the torus of radii 2 and 1 (here scaled) that has
  // (distance from the axis − 2)² + z² = 1. The scale follows from the tube's width of 2 · 0.55.
  const auto at = [&](int row, int column) { return mesh.vertices[std::size_t(row * 481 + column)].position; };
  const float scale = glm::distance(at(0, 0), at(kSides / 2, 0)) / 1.1f;
  glm::vec3 sum(0.0f);
  for (int column = 0; column < 480; ++column) sum += 0.5f * (at(0, column) + at(kSides / 2, column));
  const glm::vec3 middle = sum / 480.0f;
  for (int column = 0; column < 480; column += 7) {
    const glm::vec3 center = (0.5f * (at(0, column) + at(kSides / 2, column)) - middle) / scale;
    const float beyond = std::hypot(center.x, center.y) - 2.0f;
    EXPECT_NEAR(beyond * beyond + center.z * center.z, 1.0f, 1e-3f) << column;
  }
}

TEST(PlaneMesh, FacesUp) {
  const Mesh mesh = planeMesh();
  expectUnitBounds(meshScene(mesh));
  expectSound(mesh, 0.999f);
  expectTangentsAlongU(mesh, 0.999f);
  for (const Vertex& vertex : mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 1, 0));
}

TEST(CubeMesh, HasSixUprightFaces) {
  const Mesh mesh = cubeMesh();
  expectUnitBounds(meshScene(mesh));
  expectSound(mesh, 0.999f);
  expectTangentsAlongU(mesh, 0.999f);
  expectEdgesPaired(mesh);
  EXPECT_NEAR(signedVolume(mesh), std::pow(2.0 / std::numbers::sqrt3, 3.0), 1e-6);
  for (const Vertex& vertex : mesh.vertices) {
    const bool standing = vertex.normal.y == 0.0f;  // v = 0 is its upper edge
    EXPECT_TRUE(!standing || (vertex.position.y > 0.0f) == (vertex.uv[0].y == 0.0f));
  }
}

}  // namespace
}  // namespace mirrorball
