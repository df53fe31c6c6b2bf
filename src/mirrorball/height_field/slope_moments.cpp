#include "mirrorball/height_field/slope_moments.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/height_rows.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRowsAtOnce = 16;

/// Slopes by rows: so that those of a large map are never in memory all at a time.
struct SlopeRows {
  glm::ivec2 size;
  /// Writes (∂d/∂u, 0, ∂d/∂v) of each texel of a row, to be multiplied by `unit`.
  std::function<void(int y, float* to)> write;
  glm::vec2 unit;
};

float greatestSlope(const SlopeRows& rows) {
  std::vector<float> of_rows(std::size_t(rows.size.y), 0.0f);
  parallelFor(of_rows.size(), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
    std::vector<float> row(3 * std::size_t(rows.size.x));
    for (std::size_t y = begin; y < end; ++y) {
      rows.write(static_cast<int>(y), row.data());
      for (std::size_t i = 0; i < row.size(); i += 3)
        of_rows[y] = std::max({of_rows[y], std::abs(row[i] * rows.unit.x), std::abs(row[i + 2] * rows.unit.y)});
    }
  });
  return *std::max_element(of_rows.begin(), of_rows.end());
}

/// Some rows over `greatest`, without variances.
Image bandOf(const SlopeRows& rows, int first, int end, float greatest) {
  Image band = Image::withoutValues(rows.size.x, end - first, 4);
  std::vector<float> row(3 * std::size_t(rows.size.x));
  for (int y = first; y < end; ++y) {
    rows.write(y, row.data());
    for (int x = 0; x < rows.size.x; ++x) {
      const float* const slope = &row[3 * std::size_t(x)];
      float* const texel = band.texel(x, y - first);
      texel[0] = slope[0] * rows.unit.x / greatest;
      texel[1] = slope[2] * rows.unit.y / greatest;
      texel[2] = texel[3] = 0.0f;
    }
  }
  return band;
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

glm::ivec2 coarserSize(glm::ivec2 size) { return glm::max(size / 2, 1); }

void writeCoarser(const Image& fine, int y, float* to) {
  const glm::ivec2 fine_size(fine.width(), fine.height());
  const glm::ivec2 size = coarserSize(fine_size);
  for (int x = 0; x < size.x; ++x) {
    const glm::ivec2 place(x, y);
    glm::ivec2 last = glm::min(2 * place + 2, fine_size);
    if (x == size.x - 1) last.x = fine_size.x;
    if (y == size.y - 1) last.y = fine_size.y;
    const glm::vec4 moments = momentsOf(fine, 2 * place, last);
    std::copy_n(&moments.x, 4, to + 4 * std::size_t(x));
  }
}

Image coarser(const Image& fine) {
  const glm::ivec2 size = coarserSize({fine.width(), fine.height()});
  Image coarse = Image::withoutValues(size.x, size.y, 4);
  parallelFor(std::size_t(size.y), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      writeCoarser(fine, static_cast<int>(y), coarse.row(static_cast<int>(y)).data());
  });
  return coarse;
}

/// The level `finest` of all, row by row from the bands that its rows cover: the last one has what is left.
Image levelOf(const SlopeRows& rows, int finest, float greatest) {
  Image level = Image::withoutValues(levelSide(rows.size.x, finest), levelSide(rows.size.y, finest), 4);
  parallelFor(std::size_t(level.height()), 1 + (kRowsAtOnce >> finest), [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      Image band = bandOf(rows, y << finest, y == level.height() - 1 ? rows.size.y : (y + 1) << finest, greatest);
      for (int step = 0; step < finest; ++step) {
        const glm::ivec2 size = coarserSize({band.width(), band.height()});
        Image coarse = Image::withoutValues(size.x, size.y, 4);
        for (int row = 0; row < size.y; ++row) writeCoarser(band, row, coarse.row(row).data());
        band = std::move(coarse);
      }
      std::copy(band.row(0).begin(), band.row(0).end(), level.row(y).data());
    }
  });
  return level;
}

Result<SlopeMoments> momentsOf(const SlopeRows& rows, int finest) {
  const glm::ivec2 size(levelSide(rows.size.x, finest), levelSide(rows.size.y, finest));
  MIRRORBALL_TRY_VOID(checkMemory(std::uint64_t(size.x) * std::uint64_t(size.y) * 4 * sizeof(float) * 4 / 3));
  const int levels = levelCount(std::max(size.x, size.y));
  SlopeMoments moments{ImageSet(levels, 1), std::max(greatestSlope(rows), 1e-6f)};
  moments.levels.at(0, 0) = levelOf(rows, finest, moments.unit);
  for (int level = 1; level < levels; ++level) moments.levels.at(level, 0) = coarser(moments.levels.at(level - 1, 0));
  return moments;
}

}  // namespace

Result<SlopeMoments> slopeMoments(const Image& heights, MapEdges edges, int finest) {
  MIRRORBALL_TRY_VOID(checkHeights(heights));
  const glm::ivec2 size(heights.width(), heights.height());
  const HeightFieldSettings settings{.edges = edges, .scale = 1.0f / static_cast<float>(size.x)};
  const auto write = [&](int y, float* to) {
    const HeightRows rows{heights.row(texelBeyond(y - 1, size.y, edges)).data(), heights.row(y).data(),
                          heights.row(texelBeyond(y + 1, size.y, edges)).data(), size.x};
    writeSlopes(rows, settings, SlopeMap::derivatives, to);
  };
  // In units of texture coordinates.
  return momentsOf(SlopeRows{size, write, glm::vec2(size)}, finest);
}

Result<SlopeMoments> momentsOfSlopes(const Image& slopes, int finest) {
  const auto write = [&](int y, float* to) { std::copy(slopes.row(y).begin(), slopes.row(y).end(), to); };
  return momentsOf(SlopeRows{{slopes.width(), slopes.height()}, write, glm::vec2(1.0f)}, finest);
}

}  // namespace mirrorball
