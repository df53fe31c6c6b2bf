#include "mirrorball/height_field/maximum_pyramid.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstddef>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/height_rows.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRowsPerReduction = 32;

/// Level 0.
///
/// errors   non_finite; interrupted
Result<Image> patchMaxima(const Image& heights, MapEdges edges, const ProgressFunction& progress) {
  const int width = heights.width();
  const int height = heights.height();
  Image maxima = Image::withoutValues(width, height, 1);
  const int right = texelBeyond(width, width, edges);
  // Each row is looked at while it is near; only where one is bad it is asked which texel that is.
  std::atomic<bool> is_finite = true;
  ProgressCounter counter(progress, std::size_t(height));
  parallelFor(std::size_t(height), kRowsPerReduction, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    for (int y = int(begin); y < int(end); ++y) {
      const float* row = heights.row(y).data();
      const float* below = heights.row(texelBeyond(y + 1, height, edges)).data();
      float* to = maxima.row(y).data();
      if (!areFinite(row, width)) is_finite = false;
      writePatchMaxima(row, below, width - 1, to);
      to[width - 1] = std::max({row[width - 1], row[right], below[width - 1], below[right]});
    }
    counter.advance(end - begin);
  });
  if (!is_finite) MIRRORBALL_TRY_VOID(checkHeights(heights));
  MIRRORBALL_TRY_VOID(counter.result());
  return maxima;
}

/// Raises a row of the next level to a row of this one.
void raise(float* to, int to_width, const float* row, int width) {
  for (int x = 0; x < width; ++x) {
    float& cell = to[std::min(x / 2, to_width - 1)];
    cell = std::max(cell, row[x]);
  }
}

/// The level after one of more than one cell.
Image nextLevel(const Image& level) {
  const int width = level.width();
  const int height = level.height();
  Image next = Image::withoutValues(levelSide(width, 1), levelSide(height, 1), 1);
  parallelFor(std::size_t(next.height()), kRowsPerReduction, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y) {
      float* to = next.row(y).data();
      const float* row = level.row(std::min(2 * y, height - 1)).data();
      const float* below = level.row(std::min(2 * y + 1, height - 1)).data();
      const int pairs = width / 2;
      writePairMaxima(row, below, pairs, to);
      if (pairs == 0) to[0] = std::max(row[0], below[0]);
      if (width % 2 != 0) to[next.width() - 1] = std::max({to[next.width() - 1], row[width - 1], below[width - 1]});
      if (y == next.height() - 1 && height % 2 != 0) raise(to, next.width(), level.row(height - 1).data(), width);
    }
  });
  return next;
}

}  // namespace

Result<ImageSet> maximumPyramid(const Image& heights, MapEdges edges, const ProgressFunction& progress) {
  assert(!heights.empty() && heights.channels() == 1);
  MIRRORBALL_TRY_VOID(checkMemory(heights.texelCount() * sizeof(float) * 3 / 2));
  const int levels = levelCount(std::max(heights.width(), heights.height()));
  ImageSet pyramid(levels, 1);
  MIRRORBALL_TRY(finest, patchMaxima(heights, edges, progress));
  pyramid.at(0, 0) = std::move(finest);
  for (int level = 1; level < levels; ++level) pyramid.at(level, 0) = nextLevel(pyramid.at(level - 1, 0));
  return pyramid;
}

}  // namespace mirrorball
