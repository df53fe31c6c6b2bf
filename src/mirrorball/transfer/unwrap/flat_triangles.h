#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/ext/vector_int2_sized.hpp>
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
  /// The cells that a triangle's box touches, from the lower left one to the upper right one.
  struct CellRange {
    glm::i64vec2 low{0};
    glm::i64vec2 high{0};
    /// A needle that lies askew has a box of more cells than all other triangles together.
    bool isWide() const {
      constexpr std::int64_t kMostCells = 4096;
      return (high.x - low.x + 1) * (high.y - low.y + 1) > kMostCells;
    }
  };
  CellRange cellsOf(const std::array<glm::dvec2, 3>& corners) const;

  /// Calls `visit(cell)` for those of a range, until it returns true.
  template <typename Visit>
  bool anyCell(const CellRange& range, const Visit& visit) const;

  double cell_ = 0.0;
  std::vector<std::array<glm::dvec2, 3>> triangles_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
  std::vector<std::uint32_t> wide_;  ///< in no cell, and asked for each other triangle
};

}  // namespace mirrorball
