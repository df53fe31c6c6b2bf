#include "mirrorball/height_field/cone_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/cone_search.h"
#include "mirrorball/height_field/maximum_pyramid.h"

namespace mirrorball {

Result<Image> coneMap(const Image& heights, ConeKind kind, MapEdges edges, const ProgressFunction& progress) {
  MIRRORBALL_TRY(maxima, maximumPyramid(heights, edges));
  MIRRORBALL_TRY_VOID(checkRange(heights));
  const std::uint64_t floats_a_texel = kind == ConeKind::relaxed ? 9 : 3;
  MIRRORBALL_TRY_VOID(checkMemory(heights.texelCount() * sizeof(float) * floats_a_texel));
  const ConeSearch search(heights, std::move(maxima), kind, edges);
  const int width = heights.width();
  Image cones = Image::withoutValues(width, heights.height(), 1);
  // A ratio of 1, the widest: a height of 1 over a texture width.
  const float least_slope = 1.0f / static_cast<float>(width);
  ProgressCounter counter(progress, std::size_t(heights.height()));
  parallelFor(std::size_t(heights.height()), 1, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    for (int y = int(begin); y < int(end); ++y) {
      SurfacePatch nearby{{0, y}, {0, 0}};
      for (int x = 0; x < width; ++x) {
        const float squared = search.squaredSlope({x, y}, least_slope * least_slope, nearby);
        cones.texel(x, y)[0] = std::min(std::sqrt(least_slope / std::sqrt(squared)), 1.0f);
      }
    }
    counter.advance(end - begin);
  });
  MIRRORBALL_TRY_VOID(counter.result());
  return cones;
}

}  // namespace mirrorball
