#include "mirrorball/height_field/normal_levels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/glm.hpp>

#include "formula/surface.h"
#include "mirrorball/image/halve.h"

namespace mirrorball {
namespace {

constexpr float kWhite = 255.0f;
constexpr float kShortest = 0.05f;  // several steps of 8 bits: of less, the direction is not known

/// A unit normal with a weight of 1; without a direction all is 0.
glm::vec4 unitNormal(const std::uint8_t* texel) {
  const glm::vec3 normal = glm::vec3(texel[0], texel[1], texel[2]) * (2.0f / kWhite) - 1.0f;
  const float length = glm::length(normal);
  return length < kShortest ? glm::vec4(0.0f) : glm::vec4(normal / length, 1.0f);
}

/// The means of the first level's unit normals, of which no picture is made: it would be the largest by far.
Image halvedNormals(const Image8& normals) {
  return halvedBy<Image>(normals, [](const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c,
                                     const std::uint8_t* d, float* mean) {
    const glm::vec4 sum = 0.25f * (unitNormal(a) + unitNormal(b) + unitNormal(c) + unitNormal(d));
    std::copy_n(&sum.x, 4, mean);
  });
}

/// Of what is not below 0 but by rounding.
std::uint8_t stored(float share) { return static_cast<std::uint8_t>(kWhite * share + 0.5f); }

/// The means of a level, as a texture keeps them.
Image8 encoded(const Image& sums) {
  auto level = Image8::withoutValues(sums.width(), sums.height(), 4);
  for (int y = 0; y < sums.height(); ++y)
    for (int x = 0; x < sums.width(); ++x) {
      const float* const sum = sums.texel(x, y);
      const glm::vec3 mean = glm::vec3(sum[0], sum[1], sum[2]) / std::max(sum[3], 1e-20f);
      std::uint8_t* const texel = level.texel(x, y);
      for (int axis = 0; axis < 3; ++axis) texel[axis] = stored(0.5f + 0.5f * mean[axis]);
      const float alpha = sum[3] > 0.0f ? formula::alphaOfSpread(std::min(glm::length(mean), 1.0f)) : 1.0f;
      texel[3] = static_cast<std::uint8_t>(std::ceil(kWhite * alpha));
    }
  return level;
}

}  // namespace

std::vector<Image8> normalLevels(const Image8& normals) {
  assert(normals.channels() == 4);
  std::vector<Image8> levels{normals};
  std::span<std::uint8_t> samples = levels.front().samples();
  for (std::size_t alpha = 3; alpha < samples.size(); alpha += 4) samples[alpha] = 255;
  Image sums;
  while (levels.back().width() > 1 || levels.back().height() > 1) {
    sums = levels.size() == 1 ? halvedNormals(normals) : halved(sums);
    levels.push_back(encoded(sums));
  }
  return levels;
}

}  // namespace mirrorball
