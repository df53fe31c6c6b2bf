#include "mirrorball/height_field/cone_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/empty_cones.h"
#include "mirrorball/height_field/maximum_pyramid.h"
#include "mirrorball/height_field/relaxed_cones.h"

namespace mirrorball {

Result<Image> coneMap(const Image& heights, ConeKind kind, MapEdges edges, const ProgressFunction& progress) {
  MIRRORBALL_TRY(maxima, maximumPyramid(heights, edges));
  MIRRORBALL_TRY_VOID(checkRange(heights));
  const std::uint64_t floats_a_texel = kind == ConeKind::relaxed ? 9 : 3;
  MIRRORBALL_TRY_VOID(checkMemory(heights.texelCount() * sizeof(float) * floats_a_texel));
  const int width = heights.width();
  Image cones = Image::withoutValues(width, heights.height(), 1);
  // A ratio of 1, the widest: a height of 1 over a texture width.
  const float least_slope = 1.0f / static_cast<float>(width);
  const float least_square = least_slope * least_slope;
  std::optional<RelaxedConeSearch> search;
  if (kind == ConeKind::relaxed) search.emplace(heights, maxima, edges);
  ProgressCounter counter(progress, std::size_t(heights.height()));
  parallelFor(std::size_t(heights.height()), 1, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    for (int y = int(begin); y < int(end); ++y) {
      const std::span<float> row = cones.row(y);
      if (search)
        search->writeSteepestWays(y, least_square, row.data());
      else
        writeSteepestWays(heights, maxima, edges, y, least_square, row.data());
      for (float& cone : row) cone = std::min(std::sqrt(least_slope / std::sqrt(cone)), 1.0f);
    }
    counter.advance(end - begin);
  });
  MIRRORBALL_TRY_VOID(counter.result());
  return cones;
}

}  // namespace mirrorball
