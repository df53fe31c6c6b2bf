#include "mirrorball/height_field/slopes.h"

#include <atomic>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/height_rows.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRowsPerDifference = 16;

/// A map of three channels, each row from those of three rows of heights.
Result<Image> mapOfSlopes(const Image& heights, const HeightFieldSettings& settings, SlopeMap map,
                          const ProgressFunction& progress) {
  assert(!heights.empty() && heights.channels() == 1 && std::abs(settings.scale) <= 1e30f);
  const int width = heights.width();
  const int height = heights.height();
  MIRRORBALL_TRY_VOID(checkImageMemory(width, height, 3));
  Image slopes = Image::withoutValues(width, height, 3);
  // Each row is looked at while it is near; only where one is bad it is asked which texel that is.
  std::atomic<bool> is_finite = true;
  ProgressCounter counter(progress, std::size_t(height));
  parallelFor(std::size_t(height), kRowsPerDifference, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    for (int y = int(begin); y < int(end); ++y) {
      const HeightRows rows{heights.row(texelBeyond(y - 1, height, settings.edges)).data(), heights.row(y).data(),
                            heights.row(texelBeyond(y + 1, height, settings.edges)).data(), width};
      if (!areFinite(rows.row, width)) is_finite = false;
      writeSlopes(rows, settings, map, slopes.row(y).data());
    }
    counter.advance(end - begin);
  });
  if (!is_finite) MIRRORBALL_TRY_VOID(checkHeights(heights));
  MIRRORBALL_TRY_VOID(counter.result());
  return slopes;
}

}  // namespace

Result<Image> normalsFromHeights(const Image& heights, const HeightFieldSettings& settings,
                                 const ProgressFunction& progress) {
  return mapOfSlopes(heights, settings, SlopeMap::normals, progress);
}

Result<Image> derivativesFromHeights(const Image& heights, const HeightFieldSettings& settings,
                                     const ProgressFunction& progress) {
  return mapOfSlopes(heights, settings, SlopeMap::derivatives, progress);
}

}  // namespace mirrorball
