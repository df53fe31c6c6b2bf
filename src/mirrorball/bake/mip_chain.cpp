#include "mirrorball/bake/mip_chain.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <vector>

#include "mirrorball/base/parallel.h"

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

/// The solid angle of each texel of a face, row by row: differences of the corners' angles, each taken once.
std::vector<float> solidAngles(int side) {
  const auto columns = std::size_t(side);
  std::vector<double> corners((columns + 1) * (columns + 1));
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x)
      corners[std::size_t(y) * (columns + 1) + std::size_t(x)] =
          cubeCornerSolidAngle(2.0 * x / side - 1.0, 2.0 * y / side - 1.0);
  std::vector<float> angles(columns * columns);
  for (std::size_t y = 0; y < columns; ++y)
    for (std::size_t x = 0; x < columns; ++x) {
      const double* upper = &corners[y * (columns + 1) + x];
      const double* lower = upper + columns + 1;
      angles[y * columns + x] = static_cast<float>(upper[0] - upper[1] - lower[0] + lower[1]);
    }
  return angles;
}

Image halved(const Image& source, int side, const std::vector<float>& angles, const std::vector<Overlap>& overlaps) {
  Image target = Image::withoutValues(side, side, 3);
  const auto source_side = std::size_t(source.width());
  for (int y = 0; y < side; ++y) {
    const Overlap& down = overlaps[std::size_t(y)];
    for (int x = 0; x < side; ++x) {
      const Overlap& across = overlaps[std::size_t(x)];
      glm::vec3 sum(0.0f);
      float total = 0.0f;
      for (std::size_t j = 0; j < down.lengths.size(); ++j)
        for (std::size_t i = 0; i < across.lengths.size(); ++i) {
          const int row = down.first + static_cast<int>(j);
          const int column = across.first + static_cast<int>(i);
          const float weight =
              down.lengths[j] * across.lengths[i] * angles[std::size_t(row) * source_side + std::size_t(column)];
          sum += rgbAt(source, column, row) * weight;
          total += weight;
        }
      const glm::vec3 mean = sum / total;
      std::copy_n(&mean.x, 3, target.texel(x, y));
    }
  }
  return target;
}

Image threeChannels(const Image& image) {
  if (image.channels() == 3) return image;
  Image copy(image.width(), image.height(), 3);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec3 light = rgbAt(image, x, y);
      std::copy_n(&light.x, 3, copy.texel(x, y));
    }
  return copy;
}

}  // namespace

ImageSet mipChain(const EnvironmentMap& cube) {
  assert(cube.projection() == Projection::cube);
  const int levels = std::bit_width(static_cast<unsigned>(cube.size()));
  ImageSet chain(levels, 6);
  for (int face = 0; face < 6; ++face) chain.at(0, face) = threeChannels(cube.face(face));
  for (int level = 1; level < levels; ++level) {
    const int source_side = cube.size() >> (level - 1);
    const int side = cube.size() >> level;
    const std::vector<float> angles = solidAngles(source_side);
    std::vector<Overlap> overlaps;
    for (int texel = 0; texel < side; ++texel) overlaps.push_back(overlapOf(texel, side, source_side));
    parallelFor(6, 1, [&](std::size_t face, std::size_t) {
      chain.at(level, int(face)) = halved(chain.at(level - 1, int(face)), side, angles, overlaps);
    });
  }
  return chain;
}

}  // namespace mirrorball
