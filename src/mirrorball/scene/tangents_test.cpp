#include "mirrorball/scene/tangents.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

Vertex vertexAt(glm::vec3 position, glm::vec2 uv) {
  Vertex vertex;
  vertex.position = position;
  vertex.uv[0] = uv;
  return vertex;
}

/// In the plane z = 0, seen from +Z, with pictures that read rightly where uv = (x, −y).
Mesh flatMesh(const std::vector<glm::vec2>& places, const std::vector<glm::vec2>& uvs,
              std::vector<std::uint32_t> indices) {
  Mesh mesh;
  for (std::size_t i = 0; i < places.size(); ++i) mesh.vertices.push_back(vertexAt(glm::vec3(places[i], 0.0f), uvs[i]));
  mesh.indices = std::move(indices);
  return mesh;
}

glm::vec4 tangentAt(const Mesh& mesh, std::size_t corner) { return mesh.vertices[mesh.indices[corner]].tangent; }

void expectUnitAcross(const Mesh& mesh) {
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-5f);
    EXPECT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0.0f, 1e-5f);
    EXPECT_EQ(std::abs(vertex.tangent.w), 1.0f);
  }
}

TEST(ComputeTangents, AgreeWithTheAnalyticOnesOfASphere) {
  const Mesh analytic = sphereMesh(64, 128);
  Mesh computed = analytic;
  for (Vertex& vertex : computed.vertices) vertex.tangent = glm::vec4(0.0f);
  computeTangents(computed);
  EXPECT_EQ(computed.vertices.size(), analytic.vertices.size());
  expectUnitAcross(computed);
  for (std::size_t i = 0; i < computed.indices.size(); ++i) {
    const Vertex& vertex = computed.vertices[computed.indices[i]];
    EXPECT_EQ(vertex.tangent.w, 1.0f);
    // At the seam and the poles only one side's triangles are summed: half a segment's turn is 1.4 degrees.
    if (std::abs(vertex.position.y) > 0.99f) continue;
    EXPECT_GT(glm::dot(glm::vec3(vertex.tangent), glm::vec3(analytic.vertices[analytic.indices[i]].tangent)), 0.9995f);
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

// Left of x = 0 the picture of the right side, mirrored. The two vertices between are split.
TEST(ComputeTangents, SplitVerticesBetweenMirroredPictures) {
  Mesh mesh = flatMesh({{0, 0}, {1, 0}, {0, 1}, {-1, 0}}, {{0, 0}, {1, 0}, {0, -1}, {1, 0}}, {0, 1, 2, 0, 2, 3});
  computeTangents(mesh);
  ASSERT_EQ(mesh.vertices.size(), 6u);
  for (std::size_t corner = 0; corner < 3; ++corner) EXPECT_EQ(tangentAt(mesh, corner), glm::vec4(1, 0, 0, 1));
  for (std::size_t corner = 3; corner < 6; ++corner) EXPECT_EQ(tangentAt(mesh, corner), glm::vec4(-1, 0, 0, -1));
  for (std::size_t corner = 0; corner < 6; ++corner) {
    constexpr int kPlaces[]{0, 1, 2, 0, 2, 3};
    constexpr float kX[]{0, 1, 0, -1};
    EXPECT_EQ(mesh.vertices[mesh.indices[corner]].position.x, kX[kPlaces[corner]]);
  }
}

// Two fans that touch at a point alone, with pictures turned by a quarter against each other.
TEST(ComputeTangents, AreNotSharedAcrossAPointAlone) {
  Mesh mesh = flatMesh({{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {{0, 0}, {1, 0}, {0, -1}, {0, -1}, {-1, 0}},
                       {0, 1, 2, 0, 3, 4});
  computeTangents(mesh);
  EXPECT_EQ(mesh.vertices.size(), 6u);
  EXPECT_LT(glm::distance(tangentAt(mesh, 0), glm::vec4(1, 0, 0, 1)), 1e-6f);
  EXPECT_LT(glm::distance(tangentAt(mesh, 3), glm::vec4(0, 1, 0, 1)), 1e-6f);
}

// A square whose second triangle has all of its picture in a line.
TEST(ComputeTangents, OfATriangleWithoutAreaInThePictureAreTheNeighbours) {
  for (const float mirror : {1.0f, -1.0f}) {
    Mesh mesh =
        flatMesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 0}, {mirror, 0}, {mirror, -1}, {0, 0}}, {0, 1, 2, 0, 2, 3});
    computeTangents(mesh);
    for (std::size_t corner = 0; corner < 5; ++corner)
      EXPECT_LT(glm::distance(tangentAt(mesh, corner), glm::vec4(mirror, 0, 0, mirror)), 1e-6f) << corner;
    // At its own vertex it has nobody to follow.
    EXPECT_EQ(tangentAt(mesh, 5), glm::vec4(1, 0, 0, -1));
  }
}

TEST(ComputeTangents, OfATriangleWithTwoCornersAtOnePlaceAreThoseOfTheVertex) {
  Mesh mesh = flatMesh({{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {0, -1}, {-1, -1}}, {0, 0, 2, 0, 1, 2});
  computeTangents(mesh);
  EXPECT_EQ(mesh.vertices.size(), 3u);
  for (std::size_t corner = 0; corner < 6; ++corner)
    EXPECT_LT(glm::distance(tangentAt(mesh, corner), glm::vec4(0, -1, 0, 1)), 1e-6f) << corner;
}

TEST(ComputeTangents, OfEqualVerticesAreEqual) {
  Mesh shared = sphereMesh(16, 32);
  Mesh separate = shared;
  separate.vertices.clear();
  for (std::uint32_t& index : separate.indices) {
    separate.vertices.push_back(shared.vertices[index]);
    index = static_cast<std::uint32_t>(separate.vertices.size() - 1);
  }
  computeTangents(shared);
  computeTangents(separate);
  for (std::size_t corner = 0; corner < shared.indices.size(); ++corner)
    EXPECT_EQ(tangentAt(separate, corner), tangentAt(shared, corner));
}

TEST(ComputeTangents, WithoutTextureCoordinatesAreAnyOrthogonalUnit) {
  Mesh mesh = cubeMesh();
  for (Vertex& vertex : mesh.vertices) vertex.uv[0] = glm::vec2(0.0f);
  computeTangents(mesh);
  expectUnitAcross(mesh);
  for (const Vertex& vertex : mesh.vertices) EXPECT_EQ(vertex.tangent.w, 1.0f);
}

TEST(ComputeTangents, OfHugeTinyAndUnusedVerticesAreUnit) {
  for (const float scale : {1e-18f, 1e-6f, 1e15f, 1e18f, std::numeric_limits<float>::max()}) {
    Mesh mesh = sphereMesh(8, 16);
    for (Vertex& vertex : mesh.vertices) {
      vertex.position *= scale;
      vertex.uv[0] *= scale;
    }
    mesh.vertices.push_back(vertexAt({0, 0, 0}, {0.5f, 0.5f}));
    computeTangents(mesh);
    expectUnitAcross(mesh);
  }
  Mesh empty;
  computeTangents(empty);
  EXPECT_TRUE(empty.vertices.empty());
}

}  // namespace
}  // namespace mirrorball
