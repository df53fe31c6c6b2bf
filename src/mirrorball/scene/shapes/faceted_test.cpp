#include "mirrorball/scene/shapes/faceted.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

#include "mirrorball/scene/mesh_testing.h"

namespace mirrorball {
namespace {

using testing::expectEdgesPaired;
using testing::expectSound;
using testing::expectTangentsAlongU;
using testing::expectUnitBounds;
using testing::signedVolume;

/// A facet's corners share a normal.
std::size_t facetCount(const Mesh& mesh) {
  std::map<std::tuple<float, float, float>, int> normals;
  for (const Vertex& vertex : mesh.vertices) ++normals[{vertex.normal.x, vertex.normal.y, vertex.normal.z}];
  return normals.size();
}

/// Half the greatest distance of two corners in the horizontal plane: the girdle's radius.
double girdleRadius(const Mesh& mesh) {
  double radius = 0.0;
  for (const Vertex& vertex : mesh.vertices)
    radius = std::max(radius, std::hypot(double(vertex.position.x), double(vertex.position.z)));
  return radius;
}

TEST(BrilliantMesh, IsAClosedConvexStoneOf57FacetsAndAGirdle) {
  const Mesh mesh = brilliantMesh();
  expectUnitBounds(meshScene(mesh));
  expectSound(mesh, 0.99999f);  // flat
  expectTangentsAlongU(mesh, 0.999f);
  expectEdgesPaired(mesh);
  EXPECT_EQ(facetCount(mesh), 57u + 16u);
  for (const Vertex& on_facet : mesh.vertices)
    for (const Vertex& other : mesh.vertices)
      ASSERT_LT(glm::dot(other.position - on_facet.position, on_facet.normal), 1e-6f) << "convex";
}

// Tolkowsky's figures, measured on the mesh: 53 %, 16.2 %, 43.1 %, 34.5° and 40.75°.
TEST(BrilliantMesh, HasTolkowskysProportions) {
  const Mesh mesh = brilliantMesh();
  const double diameter = 2.0 * girdleRadius(mesh);
  double top = -1.0, bottom = 1.0, table = 0.0, girdle_low = 1.0, girdle_high = -1.0;
  for (const Vertex& vertex : mesh.vertices) {
    const glm::dvec3 place(vertex.position);
    top = std::max(top, place.y);
    bottom = std::min(bottom, place.y);
    if (vertex.normal.y > 0.9999f) table = std::max(table, std::hypot(place.x, place.z));
    if (std::abs(vertex.normal.y) < 1e-6f) {
      girdle_low = std::min(girdle_low, place.y);
      girdle_high = std::max(girdle_high, place.y);
    }
  }
  EXPECT_NEAR(2.0 * table / diameter, 0.53, 1e-6);
  EXPECT_NEAR((top - girdle_high) / diameter, 0.162, 1e-3);
  EXPECT_NEAR((girdle_low - bottom) / diameter, 0.431, 1e-3);
  const auto hasSlope = [&](double degrees) {
    const auto cosine = static_cast<float>(std::cos(glm::radians(degrees)));
    return std::ranges::count_if(
        mesh.vertices, [&](const Vertex& vertex) { return std::abs(std::abs(vertex.normal.y) - cosine) < 1e-6f; });
  };
  EXPECT_EQ(hasSlope(34.5), 8 * 4) << "corners of the crown's main facets";
  EXPECT_EQ(hasSlope(40.75), 8 * 4) << "of the pavilion's";
}

// Each half of a turn of 22.5° is made of tetrahedra and wedges about the axis, whose volumes are closed forms.
TEST(BrilliantMesh, HasItsVolume) {
  const Mesh mesh = brilliantMesh();
  const double sine = std::sin(std::numbers::pi / 8), cosine = std::cos(std::numbers::pi / 8);
  const double crown = std::tan(glm::radians(34.5)), pavilion = std::tan(glm::radians(40.75));
  const auto tetrahedron = [](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return glm::dot(a, glm::cross(b, c)) / 6.0; };
  const auto at = [&](bool turned, double radius, double height) {
    return glm::dvec3(turned ? radius * sine : 0.0, height, turned ? radius * cosine : radius);
  };
  // A sixteenth of the pavilion, seen from the middle of the girdle's lower edge.
  const glm::dvec3 girdle = at(false, 1, 0), turned_girdle = at(true, 1, 0);
  const glm::dvec3 lower = at(true, 0.23, -pavilion * (1 - 0.23 * cosine));
  const double below =
      tetrahedron(girdle, lower, {0, -pavilion, 0}) * -1 + tetrahedron(girdle, turned_girdle, lower) * -1;
  // Of the crown: from the middle of the girdle's upper edge to half a main facet, an upper half, half a star, and the
  // table's triangle.
  const double star_radius = (0.53 * cosine + 1) / 2;
  const glm::dvec3 star = at(true, star_radius, crown * (1 - star_radius * cosine));
  const double height = crown * (1 - 0.53);
  const glm::dvec3 table = at(false, 0.53, height), middle(0, height, 0);
  const glm::dvec3 edge = at(true, 0.53 * cosine, height);  // the middle of the table's edge
  const double above = tetrahedron(girdle, star, table) + tetrahedron(girdle, turned_girdle, star) +
                       tetrahedron(table, star, edge) + tetrahedron(table, edge, middle);
  const double belt = 0.5 * sine * 0.04;
  const double exact = 16.0 * (std::abs(below) + std::abs(above) + belt) * std::pow(girdleRadius(mesh), 3.0);
  EXPECT_NEAR(signedVolume(mesh), exact, 1e-5 * exact);
}

TEST(PrismMesh, IsAClosedEquilateralPrismLyingOnASide) {
  const Mesh mesh = prismMesh();
  expectUnitBounds(meshScene(mesh));
  expectSound(mesh, 0.99999f);
  expectTangentsAlongU(mesh, 0.999f);
  expectEdgesPaired(mesh);
  EXPECT_EQ(facetCount(mesh), 5u);
  glm::vec3 low(1.0f), high(-1.0f);
  for (const Vertex& vertex : mesh.vertices) {
    low = glm::min(low, vertex.position);
    high = glm::max(high, vertex.position);
    const bool is_lying = vertex.normal.y < -0.9999f;
    EXPECT_TRUE(!is_lying || vertex.position.y == low.y);
    // The two slopes face 60° away from each other's continuation: the apex's angle is 60°.
    const bool is_slope = std::abs(vertex.normal.x) > 0.01f;
    EXPECT_NEAR(vertex.normal.y, is_slope ? 0.5f : is_lying ? -1.0f : 0.0f, 1e-6f);
  }
  const double side = high.x - low.x;
  EXPECT_NEAR(high.y - low.y, side * std::numbers::sqrt3 / 2, 1e-6);
  EXPECT_NEAR(high.z - low.z, 1.5 * side, 1e-6);
  const double exact = std::numbers::sqrt3 / 4 * 1.5 * side * side * side;
  EXPECT_NEAR(signedVolume(mesh), exact, 1e-5 * exact);
}

}  // namespace
}  // namespace mirrorball
