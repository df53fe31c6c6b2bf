// Conservative cones, in vector instructions: a lane for each tip. What is steepest of a patch is told, tip by tip, at
// RelaxedConeSearch::steepestOf.

#include "mirrorball/height_field/empty_cones.h"

#include <algorithm>
#include <array>

#include "mirrorball/base/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/height_field/empty_cones.cpp"
// Highway needs its headers in this order.
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#ifndef MIRRORBALL_EMPTY_CONES_ONCE
#define MIRRORBALL_EMPTY_CONES_ONCE
namespace mirrorball {

/// What all searches of a row share.
struct EmptyConeRow {
  const Image& heights;
  const ImageSet& maxima;
  MapEdges edges;
  int y;
};

inline constexpr std::size_t kMostConeLevels = 31;
inline constexpr std::size_t kMostConeChildren = 9;
inline constexpr int kMostTips = 16;

}  // namespace mirrorball
#endif

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, kMostTips>;
using Floats = hn::Vec<Lanes>;
using Choice = hn::Mask<Lanes>;

/// Tips side by side, and the steepest ways that are known.
struct Tips {
  int x;  ///< of the first
  Floats height;
  Floats place;  ///< x of each
  Floats best;
};

struct ConeNode {
  int level;
  int x;
  int y;
  glm::ivec2 shift;
};

/// Raises the best of the lanes that are meant to the fraction, where that is more.
void raise(Tips& tips, Choice meant, Floats numerator, Floats denominator) {
  const Choice more = hn::And(meant, numerator > tips.best * denominator);
  tips.best = hn::IfThenElse(more, numerator / denominator, tips.best);
}

/// A point of the surface, from each tip.
struct Corner {
  Floats x;
  float y;
  Floats height;
};

void raiseToCorner(Lanes d, Tips& tips, const Corner& corner) {
  raise(tips, corner.height > hn::Zero(d), corner.height * corner.height,
        corner.x * corner.x + hn::Set(d, corner.y * corner.y));
}

/// Of a straight edge what is between its ends.
void raiseToEdge(Lanes d, Tips& tips, Choice meant, const Corner& begin, const Corner& end, float along_x) {
  const float along_y = end.y - begin.y;
  const Floats h = begin.height;
  const Floats b = end.height - h;
  const Floats alpha = begin.x * begin.x + hn::Set(d, begin.y * begin.y);
  const Floats beta = begin.x * hn::Set(d, along_x) + hn::Set(d, begin.y * along_y);
  const Floats gamma = hn::Set(d, along_x * along_x + along_y * along_y);
  const Floats over = b * alpha - h * beta;
  const Floats under = h * gamma - b * beta;
  raise(tips, hn::And(meant, hn::And(over > hn::Zero(d), under > over)),
        h * h * gamma - hn::Set(d, 2.0f) * h * b * beta + b * b * alpha, alpha * gamma - beta * beta);
}

void tryPatch(Lanes d, const EmptyConeRow& row, Tips& tips, const ConeNode& patch) {
  const Image& heights = row.heights;
  const int next_x = texelBeyond(patch.x + 1, heights.width(), row.edges);
  const int next_y = texelBeyond(patch.y + 1, heights.height(), row.edges);
  const float near = heights.texel(patch.x, patch.y)[0];
  const float right = heights.texel(next_x, patch.y)[0];
  const float below = heights.texel(patch.x, next_y)[0];
  const float far = heights.texel(next_x, next_y)[0];
  const Floats one = hn::Set(d, 1.0f);
  const Floats x = hn::Set(d, float(patch.x + patch.shift.x)) - tips.place;
  const auto y = float(patch.y + patch.shift.y - row.y);
  const auto cornerAt = [&](Floats place, float down, float height) {
    return Corner{place, down, hn::Set(d, height) - tips.height};
  };
  const Corner at_near = cornerAt(x, y, near);
  const Corner at_right = cornerAt(x + one, y, right);
  const Corner at_below = cornerAt(x, y + 1.0f, below);
  const Corner at_far = cornerAt(x + one, y + 1.0f, far);
  for (const Corner* corner : {&at_near, &at_right, &at_below, &at_far}) raiseToCorner(d, tips, *corner);

  const Floats zero = hn::Zero(d);
  const Choice all = x == x;
  raiseToEdge(d, tips, all, at_near, at_right, 1.0f);
  raiseToEdge(d, tips, all, at_below, at_far, 1.0f);
  raiseToEdge(d, tips, all, at_near, at_below, 0.0f);
  raiseToEdge(d, tips, all, at_right, at_far, 0.0f);

  const Choice is_left = x == zero;
  const bool is_beside_row = y == 0.0f || y == -1.0f;
  const Choice at_tip = is_beside_row ? hn::Or(is_left, x == hn::Neg(one)) : x < x;
  if (near + far > right + below)
    raiseToEdge(d, tips, hn::Not(at_tip), at_near, at_far, 1.0f);
  else
    raiseToEdge(d, tips, hn::Not(at_tip), at_right, at_below, -1.0f);
  if (!is_beside_row) return;
  const bool is_upper = y == 0.0f;
  const Floats beside =
      hn::IfThenElse(is_left, is_upper ? at_right.height : at_far.height, is_upper ? at_near.height : at_below.height);
  const Floats above =
      hn::IfThenElse(is_left, is_upper ? at_below.height : at_near.height, is_upper ? at_far.height : at_right.height);
  const Floats up_x = hn::Max(beside, zero);
  const Floats up_y = hn::Max(above, zero);
  raise(tips, at_tip, up_x * up_x + up_y * up_y, one);
}

/// Whether a node may change what is known of a tip.
bool mayMatter(Lanes d, const EmptyConeRow& row, const Tips& tips, const ConeNode& node) {
  const Image& cells = row.maxima.at(node.level, 0);
  const Floats zero = hn::Zero(d);
  const Floats rise = hn::Max(
      hn::Set(d, cells.samples()[std::size_t(node.y) * std::size_t(cells.width()) + std::size_t(node.x)]) - tips.height,
      zero);
  const int begin_x = (node.x << node.level) + node.shift.x;
  const int begin_y = (node.y << node.level) + node.shift.y - row.y;
  const int end_x = node.x == cells.width() - 1 ? row.heights.width() + node.shift.x : begin_x + (1 << node.level);
  const int end_y =
      node.y == cells.height() - 1 ? row.heights.height() + node.shift.y - row.y : begin_y + (1 << node.level);
  const Floats nearest_x =
      hn::Max(hn::Max(hn::Set(d, float(begin_x)) - tips.place, tips.place - hn::Set(d, float(end_x))), zero);
  const auto nearest_y = float(std::max(std::max(begin_y, -end_y), 0));
  const Floats squared_distance = nearest_x * nearest_x + hn::Set(d, nearest_y * nearest_y);
  return !hn::AllFalse(d, rise * rise > tips.best * squared_distance);
}

/// The ones on the tips' side last, for they are taken up first.
int pushChildren(Lanes d, const EmptyConeRow& row, const Tips& tips, const ConeNode& node, ConeNode* stack) {
  const Image& cells = row.maxima.at(node.level, 0);
  const Image& finer = row.maxima.at(node.level - 1, 0);
  const int across = node.x == cells.width() - 1 ? finer.width() - 2 * node.x : 2;
  const int down = node.y == cells.height() - 1 ? finer.height() - 2 * node.y : 2;
  const bool is_left = tips.x < ((2 * node.x + 1) << (node.level - 1)) + node.shift.x;
  const bool is_upper = row.y < ((2 * node.y + 1) << (node.level - 1)) + node.shift.y;
  int count = 0;
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < across; ++i) {
      const ConeNode child{node.level - 1, 2 * node.x + (is_left ? across - 1 - i : i),
                           2 * node.y + (is_upper ? down - 1 - j : j), node.shift};
      if (mayMatter(d, row, tips, child)) stack[count++] = child;
    }
  return count;
}

/// Finds the steepest ways of as many tips as there are lanes.
///
/// heights   of the tips; of lanes without one, above all others
/// returns   how many lanes there are
int searchTips(const EmptyConeRow& row, int x, const float* heights, float min_square, float* squares) {
  const Lanes d;
  Tips tips{x, hn::Load(d, heights), hn::Iota(d, float(x)), hn::Set(d, min_square)};
  std::array<ConeNode, kMostConeLevels * kMostConeChildren> stack;
  int count = 0;
  const int top = row.maxima.levels() - 1;
  const auto pushCopy = [&](int i, int j) {
    const ConeNode root{top, 0, 0, {i * row.heights.width(), j * row.heights.height()}};
    if (mayMatter(d, row, tips, root)) stack[std::size_t(count++)] = root;
  };
  // Of a tiled map the eight copies around it too: the nearest copy of any place is in one of them.
  if (row.edges == MapEdges::tiled)
    for (int copy = 0; copy < 9; ++copy)
      if (copy != 4) pushCopy(copy % 3 - 1, copy / 3 - 1);
  pushCopy(0, 0);
  while (count > 0) {
    const ConeNode node = stack[std::size_t(--count)];
    if (!mayMatter(d, row, tips, node)) continue;
    if (node.level == 0)
      tryPatch(d, row, tips, node);
    else
      count += pushChildren(d, row, tips, node, &stack[std::size_t(count)]);
  }
  hn::Store(tips.best, d, squares);
  return static_cast<int>(hn::Lanes(d));
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <limits>

namespace mirrorball {

HWY_EXPORT(searchTips);

void writeSteepestWays(const Image& heights, const ImageSet& maxima, MapEdges edges, int y, float min_square,
                       float* squares) {
  const EmptyConeRow row{heights, maxima, edges, y};
  const int width = heights.width();
  for (int x = 0; x < width;) {
    alignas(64) std::array<float, kMostTips> tips;
    alignas(64) std::array<float, kMostTips> found;
    tips.fill(std::numeric_limits<float>::max());
    std::copy_n(heights.texel(x, y), std::min(kMostTips, width - x), tips.begin());
    const int lanes = HWY_DYNAMIC_DISPATCH(searchTips)(row, x, tips.data(), min_square, found.data());
    std::copy_n(found.begin(), std::min(lanes, width - x), squares + x);
    x += lanes;
  }
}

}  // namespace mirrorball
#endif
