#include "mirrorball/scene/mesh.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mirrorball
