#include "mirrorball/scene/shapes/faceted.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using glm::dvec2;
using glm::dvec3;

/// A flat convex polygon, its corners counter-clockwise from outside.
void addFacet(Mesh& mesh, std::span<const dvec3> corners) {
  dvec3 sum(0.0);  // Newell's normal
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  const dvec3 normal = glm::normalize(sum);
  const dvec3 horizontal = glm::cross(dvec3(0, 1, 0), normal);
  const dvec3 right = glm::length(horizontal) > 1e-6 ? glm::normalize(horizontal) : dvec3(1, 0, 0);
  const dvec3 up = glm::cross(normal, right);

  dvec2 low(1e30), high(-1e30);
  const auto inPlane = [&](dvec3 corner) { return dvec2(glm::dot(corner, right), -glm::dot(corner, up)); };
  for (const dvec3& corner : corners) {
    low = glm::min(low, inPlane(corner));
    high = glm::max(high, inPlane(corner));
  }
  const double side = std::max(high.x - low.x, high.y - low.y);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const dvec3& corner : corners) {
    Vertex vertex;
    vertex.position = glm::vec3(corner);
    vertex.normal = glm::vec3(normal);
    vertex.tangent = glm::vec4(glm::vec3(right), 1.0f);
    vertex.uv[0] = vertex.uv[1] = glm::vec2((inPlane(corner) - low) / side);
    mesh.vertices.push_back(vertex);
  }
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i)
    mesh.indices.insert(mesh.indices.end(), {first, first + i, first + i + 1});
}

void addFacet(Mesh& mesh, std::initializer_list<dvec3> corners) {
  addFacet(mesh, std::span(corners.begin(), corners.size()));
}

/// The stone's corners, in radii of the girdle, whose upper edge is at height 0. They come in turns of 22.5°.
struct Brilliant {
  static constexpr double kTable = 0.53;
  static constexpr double kStar = 0.5;
  static constexpr double kLowerHalf = 0.77;
  static constexpr double kGirdle = -2 * 0.02;
  const double crown_slope = std::tan(glm::radians(34.5));
  const double pavilion_slope = std::tan(glm::radians(40.75));
  const double cosine = std::cos(std::numbers::pi / 8);

  static dvec3 at(int turns, double radius, double height) {
    // The same corner is the same numbers, however often one has gone around.
    const double angle = (turns + 16) % 16 * std::numbers::pi / 8;
    return {radius * std::sin(angle), height, radius * std::cos(angle)};
  }
  dvec3 girdleTop(int turns) const { return at(turns, 1.0, 0.0); }
  dvec3 girdleBottom(int turns) const { return at(turns, 1.0, kGirdle); }
  dvec3 culet() const { return {0.0, kGirdle - pavilion_slope, 0.0}; }

  // The main facets are at the even turns. Their planes' slopes are those of the angles: at a corner between two of
  // them, the distance along either's slope is its radius times cos 22.5°.

  dvec3 table(int turns) const { return at(turns, kTable, crown_slope * (1.0 - kTable)); }
  dvec3 star(int turns) const {
    const double radius = std::lerp(kTable * cosine, 1.0, kStar);
    return at(turns, radius, crown_slope * (1.0 - radius * cosine));
  }
  dvec3 pavilion(int turns) const {
    const double radius = 1.0 - kLowerHalf;
    return at(turns, radius, kGirdle - pavilion_slope * (1.0 - radius * cosine));
  }
};

}  // namespace

Mesh brilliantMesh() {
  const Brilliant stone;
  Mesh mesh;
  std::array<dvec3, 8> table;
  for (int i = 0; i < 8; ++i) table[std::size_t(i)] = stone.table(2 * i);
  addFacet(mesh, table);
  for (int i = 0; i < 16; i += 2) {
    addFacet(mesh, {stone.table(i), stone.star(i - 1), stone.girdleTop(i), stone.star(i + 1)});
    addFacet(mesh, {stone.table(i), stone.star(i + 1), stone.table(i + 2)});
    addFacet(mesh, {stone.star(i + 1), stone.girdleTop(i), stone.girdleTop(i + 1)});
    addFacet(mesh, {stone.star(i + 1), stone.girdleTop(i + 1), stone.girdleTop(i + 2)});
    addFacet(mesh, {stone.girdleBottom(i), stone.pavilion(i + 1), stone.girdleBottom(i + 1)});
    addFacet(mesh, {stone.girdleBottom(i + 1), stone.pavilion(i + 1), stone.girdleBottom(i + 2)});
    addFacet(mesh, {stone.girdleBottom(i), stone.pavilion(i - 1), stone.culet(), stone.pavilion(i + 1)});
  }
  for (int i = 0; i < 16; ++i)
    addFacet(mesh, {stone.girdleTop(i), stone.girdleBottom(i), stone.girdleBottom(i + 1), stone.girdleTop(i + 1)});
  fitToUnitSphere(mesh);
  return mesh;
}

Mesh prismMesh() {
  constexpr double kHalfLength = 0.75;
  const double height = std::numbers::sqrt3 / 2;
  const auto left = [&](double z) { return dvec3(-0.5, 0.0, z); };
  const auto right = [&](double z) { return dvec3(0.5, 0.0, z); };
  const auto top = [&](double z) { return dvec3(0.0, height, z); };
  constexpr double kFront = kHalfLength, kBack = -kHalfLength;
  Mesh mesh;
  addFacet(mesh, {left(kFront), right(kFront), top(kFront)});
  addFacet(mesh, {right(kBack), left(kBack), top(kBack)});
  addFacet(mesh, {right(kFront), right(kBack), top(kBack), top(kFront)});
  addFacet(mesh, {left(kBack), left(kFront), top(kFront), top(kBack)});
  addFacet(mesh, {left(kFront), left(kBack), right(kBack), right(kFront)});
  fitToUnitSphere(mesh);
  return mesh;
}

}  // namespace mirrorball
