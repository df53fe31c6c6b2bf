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
    if (std::all_of(b.begin(), b.end(), [&](dvec2 corner) { return crossOf(edge, corner - a[k]) <= tolerance; }))
      return true;
  }
  return false;
}

}  // namespace

FlatTriangles::CellRange FlatTriangles::cellsOf(const Corners& corners) const {
  if (!(cell_ > 0.0)) return {};
  constexpr double kFarthest = 1e6;  // beyond, all are one
  const auto cellAt = [&](dvec2 place) {
    return glm::i64vec2(glm::floor(glm::clamp(place / cell_, -kFarthest, kFarthest)));
  };
  return {cellAt(glm::min(glm::min(corners[0], corners[1]), corners[2])),
          cellAt(glm::max(glm::max(corners[0], corners[1]), corners[2]))};
}

template <typename Visit>
bool FlatTriangles::anyCell(const CellRange& range, const Visit& visit) const {
  for (std::int64_t y = range.low.y; y <= range.high.y; ++y)
    for (std::int64_t x = range.low.x; x <= range.high.x; ++x)
      if (visit((std::uint64_t(x) << 32u) ^ (std::uint64_t(y) & 0xffffffffu))) return true;
  return false;
}

void FlatTriangles::add(const Corners& corners) {
  const auto index = static_cast<std::uint32_t>(triangles_.size());
  triangles_.push_back(corners);
  const CellRange range = cellsOf(corners);
  if (range.isWide()) {
    wide_.push_back(index);
    return;
  }
  anyCell(range, [&](std::uint64_t cell) {
    cells_[cell].push_back(index);
    return false;
  });
}

bool FlatTriangles::overlaps(const Corners& corners) const {
  if (crossOf(corners[1] - corners[0], corners[2] - corners[0]) == 0.0) return false;
  const auto isUnder = [&](const Corners& other) {
    return !isBesideAnEdge(other, corners) && !isBesideAnEdge(corners, other);
  };
  const auto isAnyUnder = [&](const std::vector<std::uint32_t>& indices) {
    return std::any_of(indices.begin(), indices.end(), [&](std::uint32_t other) { return isUnder(triangles_[other]); });
  };
  const CellRange range = cellsOf(corners);
  if (range.isWide()) return std::any_of(triangles_.begin(), triangles_.end(), isUnder);
  return isAnyUnder(wide_) || anyCell(range, [&](std::uint64_t cell) {
           const auto found = cells_.find(cell);
           return found != cells_.end() && isAnyUnder(found->second);
         });
}

}  // namespace mirrorball
