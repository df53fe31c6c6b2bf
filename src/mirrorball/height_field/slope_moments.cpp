#include "mirrorball/height_field/slope_moments.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/glm.hpp>

#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/slopes.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRowsAtOnce = 16;

/// (∂d/∂u, 0, ∂d/∂v) times `unit`, without variances.
Image withoutVariances(const Image& differences, glm::vec2 unit) {
  Image slopes(differences.width(), differences.height(), 4);
  parallelFor(std::size_t(slopes.height()), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < slopes.width(); ++x) {
        const float* const difference = differences.texel(x, y);
        float* const slope = slopes.texel(x, y);
        slope[0] = difference[0] * unit.x;
        slope[1] = difference[2] * unit.y;
        slope[2] = slope[3] = 0.0f;
      }
  });
  return slopes;
}

float greatestSlope(const Image& slopes) {
  float greatest = 0.0f;
  for (int y = 0; y < slopes.height(); ++y)
    for (int x = 0; x < slopes.width(); ++x)
      greatest = std::max({greatest, std::abs(slopes.texel(x, y)[0]), std::abs(slopes.texel(x, y)[1])});
  return greatest;
}

/// Of all texels of a rectangle: the mean, and its variances with those between the texels.
glm::vec4 momentsOf(const Image& fine, glm::ivec2 first, glm::ivec2 end) {
  glm::vec4 sum(0.0f);
  glm::vec2 squares(0.0f);
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      const float* const texel = fine.texel(x, y);
      sum += glm::vec4(texel[0], texel[1], texel[2], texel[3]);
      squares += glm::vec2(texel[0] * texel[0], texel[1] * texel[1]);
    }
  const float count = static_cast<float>((end.x - first.x) * (end.y - first.y));
  const glm::vec2 mean = glm::vec2(sum) / count;
  const glm::vec2 between = glm::max(squares / count - mean * mean, 0.0f);
  return {mean, glm::vec2(sum.z, sum.w) / count + between};
}

Image coarser(const Image& fine) {
  const glm::ivec2 fine_size(fine.width(), fine.height());
  const glm::ivec2 size = glm::max(fine_size / 2, 1);
  Image coarse(size.x, size.y, 4);
  parallelFor(std::size_t(size.y), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < size.x; ++x) {
        const glm::ivec2 place(x, y);
        glm::ivec2 last = glm::min(2 * place + 2, fine_size);
        if (x == size.x - 1) last.x = fine_size.x;
        if (y == size.y - 1) last.y = fine_size.y;
        const glm::vec4 moments = momentsOf(fine, 2 * place, last);
        std::copy_n(&moments.x, 4, coarse.texel(x, y));
      }
  });
  return coarse;
}

/// Of slopes without variances.
SlopeMoments momentsOf(Image slopes) {
  SlopeMoments moments;
  moments.unit = std::max(greatestSlope(slopes), 1e-6f);
  for (float& value : slopes.samples()) value /= moments.unit;
  const int levels = levelCount(std::max(slopes.width(), slopes.height()));
  moments.levels = ImageSet(levels, 1);
  moments.levels.at(0, 0) = std::move(slopes);
  for (int level = 1; level < levels; ++level) moments.levels.at(level, 0) = coarser(moments.levels.at(level - 1, 0));
  return moments;
}

}  // namespace

Result<SlopeMoments> slopeMoments(const Image& heights, MapEdges edges) {
  const float per_texel = 1.0f / static_cast<float>(std::max(heights.width(), 1));
  MIRRORBALL_TRY(differences, derivativesFromHeights(heights, {.edges = edges, .scale = per_texel}));
  // In units of texture coordinates.
  return momentsOf(withoutVariances(differences, glm::vec2(heights.width(), heights.height())));
}

SlopeMoments momentsOfSlopes(const Image& slopes) { return momentsOf(withoutVariances(slopes, glm::vec2(1.0f))); }

}  // namespace mirrorball
