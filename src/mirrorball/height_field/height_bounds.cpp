#include "mirrorball/height_field/height_bounds.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "mirrorball/height_field/maximum_pyramid.h"

namespace mirrorball {
namespace {

constexpr int kCellsAcross = 8;

Image negated(Image heights) {
  for (float& height : heights.samples()) height = -height;
  return heights;
}

/// Patches along an axis, the first and the last one; those beyond the map's edges are known by edges.
struct Patches {
  int first;
  int last;
};

/// The patches of a map of `length` texels between two places; a whole tile is enough.
Patches patchesOf(float low, float high, int length, MapEdges edges) {
  const auto first = static_cast<int>(std::floor(low)), last = static_cast<int>(std::floor(high));
  if (edges == MapEdges::clamped) return {std::clamp(first, 0, length - 1), std::clamp(last, 0, length - 1)};
  if (last - first >= length) return {0, length - 1};
  const int tile = static_cast<int>(std::floor(double(first) / length)) * length;
  return {first - tile, last - tile};
}

/// Visits the cells of a level that hold them (maximum_pyramid.h says which).
template <typename Visit>
void visitCells(Patches patches, int length, int level, const Visit& visit) {
  const int last_cell = levelSide(length, level) - 1;
  for (int patch = patches.first; patch <= patches.last;) {
    const int tile = patch / length * length;
    const int cell = std::min((patch - tile) >> level, last_cell);
    visit(cell);
    patch = tile + (cell == last_cell ? length : (cell + 1) << level);
  }
}

}  // namespace

Result<HeightBounds> HeightBounds::make(const Image& heights, MapEdges edges) {
  HeightBounds bounds;
  bounds.size_ = {heights.width(), heights.height()};
  bounds.edges_ = edges;
  const auto withoutPatches = [](ImageSet pyramid) {
    if (pyramid.levels() > 1) pyramid.at(0, 0) = Image();
    return pyramid;
  };
  MIRRORBALL_TRY(highest, maximumPyramid(heights, edges));
  bounds.highest_ = withoutPatches(std::move(highest));
  MIRRORBALL_TRY(lowest, maximumPyramid(negated(heights), edges));
  bounds.lowest_ = withoutPatches(std::move(lowest));
  return bounds;
}

glm::vec2 HeightBounds::over(glm::vec2 low, glm::vec2 high) const {
  if (highest_.empty()) return {0.0f, 1.0f};
  assert(glm::all(glm::lessThanEqual(low, high)));
  const Patches across = patchesOf(low.x, high.x, size_.x, edges_);
  const Patches down = patchesOf(low.y, high.y, size_.y, edges_);
  const int longer = std::max(across.last - across.first, down.last - down.first);
  const int last_level = highest_.levels() - 1;
  int level = std::min(1, last_level);
  while (level < last_level && longer >> level >= kCellsAcross) ++level;
  float least = INFINITY, greatest = -INFINITY;
  visitCells(down, size_.y, level, [&](int y) {
    visitCells(across, size_.x, level, [&](int x) {
      least = std::min(least, -lowest_.at(level, 0).texel(x, y)[0]);
      greatest = std::max(greatest, highest_.at(level, 0).texel(x, y)[0]);
    });
  });
  return {least, greatest};
}

}  // namespace mirrorball
