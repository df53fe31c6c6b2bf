#include "mirrorball/scene/shapes/teapot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mirrorball/scene/mesh_testing.h"

namespace mirrorball {
namespace {

using testing::expectSound;
using testing::expectTangentsAlongU;
using testing::signedVolume;

using Edge = std::array<glm::dvec3, 4>;

std::array<Edge, 4> edgesOf(const BezierPatch& patch) {
  return {patch[0], patch[3], Edge{patch[0][0], patch[1][0], patch[2][0], patch[3][0]},
          Edge{patch[0][3], patch[1][3], patch[2][3], patch[3][3]}};
}

bool isPoint(const Edge& edge) {
  return std::all_of(edge.begin(), edge.end(), [&](glm::dvec3 p) { return glm::distance(p, edge[0]) < 1e-12; });
}

bool sameEdge(const Edge& a, const Edge& b) {
  bool forwards = true;
  bool backwards = true;
  for (std::size_t i = 0; i < 4; ++i) {
    forwards = forwards && glm::distance(a[i], b[i]) < 1e-12;
    backwards = backwards && glm::distance(a[i], b[3 - i]) < 1e-12;
  }
  return forwards || backwards;
}

TEST(TeapotPatches, AreThirtyTwoThatShareTheirEdges) {
  const std::vector<BezierPatch> patches = teapotPatches();
  ASSERT_EQ(patches.size(), 32u);
  int points = 0;
  int open = 0;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    for (const Edge& edge : edgesOf(patches[i])) {
      if (isPoint(edge)) {
        ++points;
        continue;
      }
      int partners = 0;
      for (std::size_t k = 0; k < patches.size(); ++k)
        if (k != i)
          for (const Edge& other : edgesOf(patches[k])) partners += sameEdge(edge, other);
      EXPECT_LE(partners, 1);
      open += partners == 0;
    }
  }
  EXPECT_EQ(points, 8);  // the middles of the lid and of the bottom
  // The lid's and the rim's edges with the gap between them; both ends of the handle and of the spout.
  EXPECT_EQ(open, 4 + 4 + 4 + 4);
}

TEST(TeapotPatches, HaveThePublishedControlPoints) {
  // Some of each part, as (x, y, z) with z up in Crow's table: here (x, z, −y).
  const glm::dvec3 published[] = {
      {1.4, 0, 2.4},         {0.784, -1.4, 2.4},
      {1.3375, 0, 2.53125},  {-1.4375, 0.805, 2.53125},
      {1.75, -0.98, 1.875},  {-2, 0, 1.35},
      {1.12, 2, 0.45},       {0.84, -1.5, 0.225},
      {1.425, -0.798, 0},    {0, 0, 0},
      {0, 0, 3.15},          {0.45, -0.8, 3.15},
      {0, 0, 2.85},          {0.112, -0.2, 2.7},
      {0.728, -1.3, 2.55},   {-1.6, 0, 2.025},
      {-2.65, -0.3, 0.9375}, {-1.9, 0.3, 0.6},
      {-3, 0, 1.35},         {1.7, -0.66, 0.6},
      {3.1, 0, 0.825},       {3.525, 0.25, 2.49375},
      {3.45, -0.15, 2.5125}, {2.4, 0.25, 2.025},
      {3.2, 0, 2.4},
  };
  for (const glm::dvec3 point : published) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const BezierPatch& patch : teapotPatches())
      for (const auto& row : patch)
        for (const glm::dvec3 control : row)
          nearest = std::min(nearest, glm::distance(control, glm::dvec3(point.x, point.z, -point.y)));
    EXPECT_LT(nearest, 1e-9) << point.x << " " << point.y << " " << point.z;
  }
}

TEST(TeapotMesh, StandsUprightWithItsSpoutTowardsPlusX) {
  const Mesh mesh = teapotMesh();
  const BoundingSphere bounds = boundingSphere(meshScene(mesh));
  EXPECT_LT(glm::length(bounds.center), 1e-5f);
  EXPECT_NEAR(bounds.radius, 1.0f, 1e-5f);

  glm::vec3 min(1e9f);
  glm::vec3 max(-1e9f);
  float spout_height = 0.0f;
  float handle_height = 0.0f;
  for (const Vertex& vertex : mesh.vertices) {
    if (vertex.position.x > max.x) spout_height = vertex.position.y;
    if (vertex.position.x < min.x) handle_height = vertex.position.y;
    min = glm::min(min, vertex.position);
    max = glm::max(max, vertex.position);
  }
  const glm::vec3 extent = max - min;
  EXPECT_NEAR(extent.y / extent.z, 3.15f / 4.0f, 0.01f);  // the body's widest circle has radius 2
  EXPECT_NEAR(extent.x / extent.y, 6.4f / 3.15f, 0.05f);
  EXPECT_GT(spout_height, handle_height);  // the spout's lip is higher than the handle's bulge
}

TEST(TeapotMesh, FacesOutwardEverywhere) {
  const Mesh mesh = teapotMesh();
  expectSound(mesh, 0.85f);  // the spout's lip bends by 28 degrees within a triangle
  expectTangentsAlongU(mesh, 0.99f);
  EXPECT_GT(signedVolume(mesh), 0.0);
  EXPECT_GT(mesh.vertices[0].normal.y, 0.9999f);  // the lid's middle, where a patch's edge is one point
}

TEST(TeapotMesh, HasNoGapBetweenLidAndRim) {
  // The patches of lid and body form one closed surface: only the ends of handle and spout are open.
  constexpr int kDivisions = 6;
  EXPECT_EQ(testing::openEdgeCount(teapotMesh(kDivisions)), 4u * 2u * kDivisions);
}

}  // namespace
}  // namespace mirrorball
