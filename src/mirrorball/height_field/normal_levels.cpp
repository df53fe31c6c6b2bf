#include "mirrorball/height_field/normal_levels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include "formula/surface.h"
#include "mirrorball/image/halve.h"

namespace mirrorball {
namespace {

constexpr float kWhite = 255.0f;
constexpr float kShortest = 0.05f;  // several steps of 8 bits: of less, the direction is not known

/// Unit normals, each with a weight of 1; without a direction all is 0.
Image unitNormals(const Image8& normals) {
  Image units(normals.width(), normals.height(), 4);
  for (int y = 0; y < normals.height(); ++y)
    for (int x = 0; x < normals.width(); ++x) {
      const std::uint8_t* const stored = normals.texel(x, y);
      const glm::vec3 normal = glm::vec3(stored[0], stored[1], stored[2]) * (2.0f / kWhite) - 1.0f;
      const float length = glm::length(normal);
      if (length < kShortest) continue;
      const glm::vec4 unit(normal / length, 1.0f);
      std::copy_n(&unit.x, 4, units.texel(x, y));
    }
  return units;
}

std::uint8_t stored(float share) { return static_cast<std::uint8_t>(std::lround(kWhite * share)); }

/// The means of a level, as a texture keeps them.
Image8 encoded(const Image& sums) {
  Image8 level(sums.width(), sums.height(), 4, 255);
  for (int y = 0; y < sums.height(); ++y)
    for (int x = 0; x < sums.width(); ++x) {
      const float* const sum = sums.texel(x, y);
      const glm::vec3 mean = glm::vec3(sum[0], sum[1], sum[2]) / std::max(sum[3], 1e-20f);
      std::uint8_t* const texel = level.texel(x, y);
      for (int axis = 0; axis < 3; ++axis) texel[axis] = stored(0.5f + 0.5f * mean[axis]);
      if (sum[3] > 0.0f) {
        const float alpha = formula::alphaOfSpread(std::min(glm::length(mean), 1.0f));
        texel[3] = static_cast<std::uint8_t>(std::ceil(kWhite * alpha));
      }
    }
  return level;
}

}  // namespace

std::vector<Image8> normalLevels(const Image8& normals) {
  assert(normals.channels() == 4);
  std::vector<Image8> levels{normals};
  for (int y = 0; y < normals.height(); ++y)
    for (int x = 0; x < normals.width(); ++x) levels.front().texel(x, y)[3] = 255;
  Image sums = unitNormals(normals);
  while (sums.width() > 1 || sums.height() > 1) {
    sums = halved(sums);
    levels.push_back(encoded(sums));
  }
  return levels;
}

}  // namespace mirrorball
