#include "mirrorball/scene/mesh_refinement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

using Place = std::tuple<float, float, float>;

Place placeOf(const Vertex& v) { return {v.position.x, v.position.y, v.position.z}; }

/// Twice the area of all triangles.
double areaOf(const Mesh& mesh) {
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]].position; };
    area += double(glm::length(glm::cross(at(1) - at(0), at(2) - at(0))));
  }
  return area;
}

/// The length of all edges along which as many triangles do not go in one direction as in the other: where a mesh ends.
double lengthOfBorders(const Mesh& mesh) {
  std::map<std::pair<Place, Place>, int> counts;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const Place a = placeOf(mesh.vertices[mesh.indices[i + k]]);
      const Place b = placeOf(mesh.vertices[mesh.indices[i + (k + 1) % 3]]);
      counts[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  double length = 0.0;
  for (const auto& [edge, count] : counts) {
    const auto [a, b] = edge;
    const glm::vec3 from(std::get<0>(a), std::get<1>(a), std::get<2>(a));
    const glm::vec3 to(std::get<0>(b), std::get<1>(b), std::get<2>(b));
    length += std::abs(count) * double(glm::distance(from, to));
  }
  return length;
}

/// Every third triangle, twice.
MeshRefiner cutTwice(const Mesh& mesh) {
  MeshRefiner refiner(mesh);
  for (int step = 0; step < 2; ++step) {
    std::vector<std::uint8_t> is_cut(refiner.mesh().indices.size() / 3, 0);
    for (std::size_t i = 0; i < is_cut.size(); i += 3) is_cut[i] = 1;
    refiner.cut(is_cut);
  }
  return refiner;
}

// A cube's corners are three vertices each: its faces are cut on both sides of an edge.
TEST(MeshRefinement, OpensNoGaps) {
  for (const char* model : {"cube", "sphere", "teapot"}) {
    const Mesh mesh = loadModel(model)->meshes[0];
    const Mesh cut = cutTwice(mesh).mesh();
    EXPECT_GT(cut.indices.size(), mesh.indices.size()) << model;
    EXPECT_NEAR(lengthOfBorders(cut), lengthOfBorders(mesh), 1e-4) << model;
    EXPECT_NEAR(areaOf(cut), areaOf(mesh), 1e-4 * areaOf(mesh)) << model;
  }
}

TEST(MeshRefinement, IsDoneAgainFromWhatIsKeptOfIt) {
  const Mesh mesh = loadModel("teapot")->meshes[0];
  const MeshRefiner refiner = cutTwice(mesh);
  Mesh again = mesh;
  refine(again, refiner.refinement());
  EXPECT_EQ(again.indices, refiner.mesh().indices);
  ASSERT_EQ(again.vertices.size(), refiner.mesh().vertices.size());
  for (std::size_t i = 0; i < again.vertices.size(); ++i) {
    EXPECT_EQ(again.vertices[i].position, refiner.mesh().vertices[i].position);
    EXPECT_EQ(again.vertices[i].normal, refiner.mesh().vertices[i].normal);
  }
}

TEST(MeshRefinement, NothingIsCutWhereNothingIsAskedFor) {
  Mesh mesh = loadModel("cube")->meshes[0];
  MeshRefiner refiner(mesh);
  refiner.cut(std::vector<std::uint8_t>(mesh.indices.size() / 3, 0));
  EXPECT_TRUE(refiner.refinement().empty());
  const std::vector<std::uint32_t> indices = mesh.indices;
  refine(mesh, refiner.refinement());
  EXPECT_EQ(mesh.indices, indices);
}

// Of a long triangle the two long edges are cut, not the short one: three pieces.
TEST(MeshRefinement, LongTrianglesAreCutAlongTheirLength) {
  Mesh mesh;
  mesh.vertices = {{.position = {0, 0, 0}}, {.position = {1, 0, 0}}, {.position = {0.5f, 20, 0}}};
  mesh.indices = {0, 1, 2};
  MeshRefiner refiner(mesh);
  EXPECT_EQ(refiner.cut(std::vector<std::uint8_t>{1}), (std::vector<std::uint32_t>{0, 0, 0}));
  EXPECT_EQ(refiner.mesh().vertices.size(), 5u);
}

// A place of a cut triangle has the normal that it had, up to its length, which nobody asks for.
TEST(MeshRefinement, NormalsBetweenVerticesStay) {
  Mesh mesh;
  mesh.vertices = {{.position = {0, 0, 0}, .normal = {0, 0, 1}},
                   {.position = {1, 0, 0}, .normal = {1, 0, 0}},
                   {.position = {0, 1, 0}, .normal = {0, 1, 0}}};
  mesh.indices = {0, 1, 2};
  MeshRefiner refiner(mesh);
  refiner.cut(std::vector<std::uint8_t>{1});
  for (const Vertex& vertex : refiner.mesh().vertices) {
    const glm::vec3 p = vertex.position;
    EXPECT_EQ(vertex.normal, glm::vec3(p.x, p.y, 1.0f - p.x - p.y));
  }
}

}  // namespace
}  // namespace mirrorball
