#include "mirrorball/transfer/unwrap/flat_triangles.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {
namespace {

using glm::dvec2;
using Corners = std::array<dvec2, 3>;

double crossOf(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Whether one of `a`'s edges has all of `b` on its outer side, or so near to it that they only touch.
bool isBesideAnEdge(const Corners& a, const Corners& b) {
  constexpr double kTouching = 1e-7;  // in shares of the edge's length, squared
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec2 edge = a[(k + 1) % 3] - a[k];
    const double tolerance = kTouching * glm::dot(edge, edge);
    if (std::ranges::all_of(b, [&](dvec2 corner) { return crossOf(edge, corner - a[k]) <= tolerance; })) return true;
  }
  return false;
}

}  // namespace

template <typename Visit>
bool FlatTriangles::anyCell(const Corners& corners, const Visit& visit) const {
  if (!(cell_ > 0.0)) return visit(0u);
  constexpr double kMostCells = 1e6;  // beside one another; beyond, all are one
  const auto cellOf = [&](double x) {
    return std::int64_t(std::floor(std::clamp(x / cell_, -kMostCells, kMostCells)));
  };
  const dvec2 low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
  const dvec2 high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
  for (std::int64_t y = cellOf(low.y); y <= cellOf(high.y); ++y)
    for (std::int64_t x = cellOf(low.x); x <= cellOf(high.x); ++x)
      if (visit((std::uint64_t(x) << 32u) ^ (std::uint64_t(y) & 0xffffffffu))) return true;
  return false;
}

void FlatTriangles::add(const Corners& corners) {
  const auto index = static_cast<std::uint32_t>(triangles_.size());
  triangles_.push_back(corners);
  anyCell(corners, [&](std::uint64_t cell) {
    cells_[cell].push_back(index);
    return false;
  });
}

bool FlatTriangles::overlaps(const Corners& corners) const {
  if (crossOf(corners[1] - corners[0], corners[2] - corners[0]) == 0.0) return false;
  return anyCell(corners, [&](std::uint64_t cell) {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return false;
    return std::ranges::any_of(found->second, [&](std::uint32_t other) {
      return !isBesideAnEdge(triangles_[other], corners) && !isBesideAnEdge(corners, triangles_[other]);
    });
  });
}

}  // namespace mirrorball
