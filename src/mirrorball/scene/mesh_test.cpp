#include "mirrorball/scene/mesh.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

/// The cube [−1, 1]³ with eight shared corners; vertex i lies at the signs of i's bits.
Mesh sharedCube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    Vertex& vertex = mesh.vertices.emplace_back();
    vertex.position = {i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f};
  }
  mesh.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                  2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return mesh;
}

TEST(ComputeNormals, WeighsByAngleSoThatDiagonalsDoNotMatter) {
  Mesh mesh = sharedCube();
  computeNormals(mesh);
  for (const Vertex& vertex : mesh.vertices)
    EXPECT_LT(glm::distance(vertex.normal, glm::normalize(vertex.position)), 1e-6f);
}

TEST(ComputeNormals, OfHugeTinyAndDegenerateTrianglesAreUnit) {
  for (const float scale : {1e-30f, 1e30f, 0.0f}) {
    Mesh mesh = sharedCube();
    for (Vertex& vertex : mesh.vertices) vertex.position *= scale;
    computeNormals(mesh);
    for (const Vertex& vertex : mesh.vertices) EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-6f) << scale;
  }
}

TEST(ComputeTangents, AgreeWithTheAnalyticOnesOfASphere) {
  const Mesh analytic = sphereMesh(64, 128);
  Mesh computed = analytic;
  for (Vertex& vertex : computed.vertices) vertex.tangent = glm::vec4(0.0f);
  computeTangents(computed);
  for (std::size_t i = 0; i < computed.vertices.size(); ++i) {
    const Vertex& vertex = computed.vertices[i];
    EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-5f);
    EXPECT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0.0f, 1e-5f);
    EXPECT_EQ(vertex.tangent.w, 1.0f);
    // At the seam and the poles only one side's triangles are summed: half a segment's turn is 1.4 degrees.
    if (std::abs(vertex.position.y) > 0.99f) continue;
    EXPECT_GT(glm::dot(glm::vec3(vertex.tangent), glm::vec3(analytic.vertices[i].tangent)), 0.9995f);
  }
}

TEST(ComputeTangents, OfAMirroredPictureTurnTheBitangent) {
  Mesh mesh = planeMesh();
  for (Vertex& vertex : mesh.vertices) vertex.uv[1].x = 1.0f - vertex.uv[1].x;
  computeTangents(mesh, 0);
  EXPECT_EQ(mesh.vertices[0].tangent, glm::vec4(1, 0, 0, 1));
  computeTangents(mesh, 1);
  EXPECT_EQ(mesh.vertices[0].tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(ComputeTangents, WithoutTextureCoordinatesAreAnyOrthogonalUnit) {
  Mesh mesh = cubeMesh();
  for (Vertex& vertex : mesh.vertices) vertex.uv[0] = glm::vec2(0.0f);
  computeTangents(mesh);
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0.0f, 1e-6f);
  }
}

}  // namespace
}  // namespace mirrorball
