#include "mirrorball/bake/prefilter/mip_chain.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

/// The share of texel `source` of a row of `source_side` that lies in texel `target` of a row of `target_side`.
struct Overlap {
  int first;                   ///< source texel
  std::vector<float> lengths;  ///< of it and its followers, in source texels
};

Overlap overlapOf(int target, int target_side, int source_side) {
  const double ratio = double(source_side) / target_side;
  const double begin = target * ratio;
  const double end = begin + ratio;
  Overlap overlap{static_cast<int>(begin), {}};
  for (int texel = overlap.first; texel < source_side && texel < end - 1e-9; ++texel)
    overlap.lengths.push_back(static_cast<float>(std::min(end, texel + 1.0) - std::max(begin, double(texel))));
  return overlap;
}

/// The solid angle of each texel of a cube's face, row by row: differences of the corners' angles, each taken once.
std::vector<float> cubeSolidAngles(int side) {
  const auto columns = std::size_t(side);
  std::vector<double> corners((columns + 1) * (columns + 1));
  parallelFor(columns + 1, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (std::size_t x = 0; x <= columns; ++x)
        corners[y * (columns + 1) + x] =
            cubeCornerSolidAngle(2.0 * double(x) / side - 1.0, 2.0 * double(y) / side - 1.0);
  });
  std::vector<float> angles(columns * columns);
  for (std::size_t y = 0; y < columns; ++y)
    for (std::size_t x = 0; x < columns; ++x) {
      const double* upper = &corners[y * (columns + 1) + x];
      const double* lower = upper + columns + 1;
      angles[y * columns + x] = static_cast<float>(upper[0] - upper[1] - lower[0] + lower[1]);
    }
  return angles;
}

/// What each texel of an image counts, row by row.
std::vector<float> weightsOf(Projection projection, glm::ivec2 size, MipWeights weights) {
  if (weights == MipWeights::box) return std::vector<float>(std::size_t(size.x) * std::size_t(size.y), 1.0f);
  if (projection == Projection::cube) return cubeSolidAngles(size.x);
  std::vector<float> angles(std::size_t(size.x) * std::size_t(size.y));
  parallelFor(std::size_t(size.y), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (std::size_t x = 0; x < std::size_t(size.x); ++x) {
        float& angle = angles[y * std::size_t(size.x) + x];
        // All texels of a panorama's row have the same.
        const bool is_known = projection == Projection::equirect && x > 0;
        angle = is_known ? (&angle)[-1] : texelSolidAngle(projection, size, glm::ivec2(x, y));
      }
  });
  return angles;
}

std::vector<Overlap> overlapsOf(int side, int source_side) {
  std::vector<Overlap> overlaps;
  for (int texel = 0; texel < side; ++texel) overlaps.push_back(overlapOf(texel, side, source_side));
  return overlaps;
}

/// Fills the rows of `target` from `begin` to before `end`.
void halveRows(const Image& source, const std::vector<float>& weights, const std::vector<Overlap>& columns,
               const std::vector<Overlap>& rows, int begin, int end, Image& target) {
  const auto source_width = std::size_t(source.width());
  for (int y = begin; y < end; ++y) {
    const Overlap& down = rows[std::size_t(y)];
    for (int x = 0; x < target.width(); ++x) {
      const Overlap& across = columns[std::size_t(x)];
      glm::vec3 sum(0.0f);
      float total = 0.0f;
      for (std::size_t j = 0; j < down.lengths.size(); ++j)
        for (std::size_t i = 0; i < across.lengths.size(); ++i) {
          const int row = down.first + static_cast<int>(j);
          const int column = across.first + static_cast<int>(i);
          const float weight =
              down.lengths[j] * across.lengths[i] * weights[std::size_t(row) * source_width + std::size_t(column)];
          sum += rgbAt(source, column, row) * weight;
          total += weight;
        }
      const glm::vec3 mean = sum / total;
      std::copy_n(&mean.x, 3, target.texel(x, y));
    }
  }
}

}  // namespace

ImageSet mipChain(EnvironmentMap map, MipWeights weights) {
  const Projection projection = map.projection();
  assert(!hasDisc(projection));
  const glm::ivec2 extent = map.extent();
  const int levels = levelCount(std::max(extent.x, extent.y));
  ImageSet images = std::move(map).takeImages();
  ImageSet chain(levels, images.faces());
  for (int face = 0; face < images.faces(); ++face) {
    Image& image = images.at(0, face);
    chain.at(0, face) = image.channels() == 3 ? std::move(image) : rgbOf(image);
  }
  for (int level = 1; level < levels; ++level) {
    const glm::ivec2 source(levelSide(extent.x, level - 1), levelSide(extent.y, level - 1));
    const glm::ivec2 size(levelSide(extent.x, level), levelSide(extent.y, level));
    const std::vector<float> texel_weights = weightsOf(projection, source, weights);
    const std::vector<Overlap> columns = overlapsOf(size.x, source.x);
    const std::vector<Overlap> rows = overlapsOf(size.y, source.y);
    for (int face = 0; face < images.faces(); ++face) {
      chain.at(level, face) = Image::withoutValues(size.x, size.y, 3);
      parallelFor(std::size_t(size.y), 16, [&](std::size_t begin, std::size_t end) {
        halveRows(chain.at(level - 1, face), texel_weights, columns, rows, static_cast<int>(begin),
                  static_cast<int>(end), chain.at(level, face));
      });
    }
  }
  return chain;
}

}  // namespace mirrorball
