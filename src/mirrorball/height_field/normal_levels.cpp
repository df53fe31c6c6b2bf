#include "mirrorball/height_field/normal_levels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/glm.hpp>

#include "formula/surface.h"
#include "mirrorball/image/halve.h"

namespace mirrorball {
namespace {

constexpr float kWhite = 255.0f;
constexpr float kShortest = 0.05f;  // several steps of 8 bits: of less, the direction is not known
constexpr float kLongest = 1e9f;    // whose square is a float

/// A unit normal with a weight of 1; without a direction all is 0.
glm::vec4 unitNormal(glm::vec3 normal) {
  const float length = glm::length(normal);
  // Of infinite or undefined numbers too.
  return length >= kShortest && length <= kLongest ? glm::vec4(normal / length, 1.0f) : glm::vec4(0.0f);
}

/// The means of the first level's unit normals, of which no picture is made: it would be the largest by far.
///
/// greatest   sample, which stands for 1
template <typename Sample>
Image halvedNormals(const ImageOf<Sample>& normals, float greatest, float zero) {
  const auto unit = [&](const Sample* texel) {
    return unitNormal(formula::decodedNormal(glm::vec3(texel[0], texel[1], texel[2]) / greatest, zero));
  };
  return halvedBy<Image>(normals, [&](const Sample* a, const Sample* b, const Sample* c, const Sample* d, float* mean) {
    const glm::vec4 sum = 0.25f * (unit(a) + unit(b) + unit(c) + unit(d));
    std::copy_n(&sum.x, 4, mean);
  });
}

/// Of what is not below 0 but by rounding.
std::uint8_t stored(float share) { return static_cast<std::uint8_t>(kWhite * share + 0.5f); }

/// Makes a level of sums of unit normals and of their weights.
///
/// store   (mean, alphaOfSpread, texel): keeps them in a texel of the level
template <typename Level, typename Store>
Level levelOfSums(const Image& sums, const Store& store) {
  auto level = Level::withoutValues(sums.width(), sums.height(), 4);
  for (int y = 0; y < sums.height(); ++y)
    for (int x = 0; x < sums.width(); ++x) {
      const float* const sum = sums.texel(x, y);
      const glm::vec3 mean = glm::vec3(sum[0], sum[1], sum[2]) / std::max(sum[3], 1e-20f);
      const float alpha = sum[3] > 0.0f ? formula::alphaOfSpread(std::min(glm::length(mean), 1.0f)) : 1.0f;
      store(mean, alpha, level.texel(x, y));
    }
  return level;
}

/// All levels.
///
/// first   the first level
/// halve   () → the sums of the second
/// store   as of levelOfSums
template <typename Level, typename Halve, typename Store>
std::vector<Level> levelsFrom(Level first, const Halve& halve, const Store& store) {
  std::vector<Level> levels;
  levels.push_back(std::move(first));
  Image sums;
  while (levels.back().width() > 1 || levels.back().height() > 1) {
    sums = levels.size() == 1 ? halve() : halved(sums);
    levels.push_back(levelOfSums<Level>(sums, store));
  }
  return levels;
}

}  // namespace

std::vector<Image8> normalLevels(const Image8& normals, float zero) {
  assert(normals.channels() == 4);
  Image8 first = normals;
  std::span<std::uint8_t> samples = first.samples();
  for (std::size_t alpha = 3; alpha < samples.size(); alpha += 4) samples[alpha] = 255;
  return levelsFrom(
      std::move(first), [&] { return halvedNormals(normals, kWhite, zero); },
      [zero](glm::vec3 mean, float alpha, std::uint8_t* texel) {
        const glm::vec3 encoded = formula::encodedNormal(mean, zero);
        for (int axis = 0; axis < 3; ++axis) texel[axis] = stored(std::max(encoded[axis], 0.0f));
        texel[3] = static_cast<std::uint8_t>(std::ceil(kWhite * alpha));
      });
}

std::vector<Image> decodedNormalLevels(const Image& normals, float zero) {
  assert(normals.channels() == 4);
  Image first = Image::withoutValues(normals.width(), normals.height(), 4);
  for (std::size_t texel = 0; texel < normals.texelCount(); ++texel) {
    const float* const from = normals.samples().data() + 4 * texel;
    const glm::vec4 decoded(formula::decodedNormal(glm::vec3(from[0], from[1], from[2]), zero), 1.0f);
    std::copy_n(&decoded.x, 4, first.samples().data() + 4 * texel);
  }
  return levelsFrom(
      std::move(first), [&] { return halvedNormals(normals, 1.0f, zero); },
      [](glm::vec3 mean, float alpha, float* texel) {
        const glm::vec4 stored(mean, alpha);
        std::copy_n(&stored.x, 4, texel);
      });
}

}  // namespace mirrorball
