#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {

/// Triangles in the plane, to ask whether another one would lie over them; in a grid, so that few are looked at.
class FlatTriangles {
 public:
  /// expected   about how many there will be
  explicit FlatTriangles(std::size_t expected) { cells_.reserve(2 * expected); }

  /// The side of a cell of the grid: about that of a triangle. Before the first is added; 0 is one cell for all.
  void setCell(double side) { cell_ = side; }

  /// corners   counter-clockwise
  void add(const std::array<glm::dvec2, 3>& corners);

  /// Whether a triangle's inside has more than an edge in common with any of them.
  bool overlaps(const std::array<glm::dvec2, 3>& corners) const;

 private:
  /// Calls `visit(cell)` for those that a triangle's box touches, until it returns true.
  template <typename Visit>
  bool anyCell(const std::array<glm::dvec2, 3>& corners, const Visit& visit) const;

  double cell_ = 0.0;
  std::vector<std::array<glm::dvec2, 3>> triangles_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace mirrorball
