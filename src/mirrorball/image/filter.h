#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace mirrorball {

/// What is seen between texels.
enum class Interpolation { bilinear, bicubic };

/// Bilinear interpolation at a continuous position, texel (i, j) having its centre at (i + ½, j + ½).
///
/// position in texels from the image's top left corner
/// fetch    vec4 fetch(int x, int y): a texel that may lie one outside the image, where the caller's rule for
///          edges answers. Its fourth component weighs it: 0 leaves it out, and the rest makes up for it.
/// returns  the weighted mean; 0 where all four weights are 0
template <typename Fetch>
glm::vec4 bilinear(glm::vec2 position, Fetch&& fetch) {
  const float left = std::floor(position.x - 0.5f);
  const float top = std::floor(position.y - 0.5f);
  const float u = position.x - 0.5f - left;
  const float v = position.y - 0.5f - top;
  const int x = static_cast<int>(left);
  const int y = static_cast<int>(top);
  const auto weighted = [&](int i, int j, float weight) {
    const glm::vec4 texel = fetch(i, j);
    const float share = weight * texel.w;
    return glm::vec4(share * texel.x, share * texel.y, share * texel.z, share);
  };
  const glm::vec4 sum = weighted(x, y, (1.0f - u) * (1.0f - v)) + weighted(x + 1, y, u * (1.0f - v)) +
                        weighted(x, y + 1, (1.0f - u) * v) + weighted(x + 1, y + 1, u * v);
  if (sum.w <= 0.0f) return glm::vec4(0.0f);
  return glm::vec4(sum.x / sum.w, sum.y / sum.w, sum.z / sum.w, sum.w);
}

/// The weights of the texels at −1, 0, 1 and 2 for a place t in [0, 1] between 0 and 1: the cubic through the two that
/// has the slope of the chord of their neighbours (Catmull and Rom 1974). Exact on parabolas.
inline std::array<float, 4> catmullRomWeights(float t) {
  return {((-0.5f * t + 1.0f) * t - 0.5f) * t, (1.5f * t - 2.5f) * t * t + 1.0f, ((-1.5f * t + 2.0f) * t + 0.5f) * t,
          (0.5f * t - 0.5f) * t * t};
}

/// Bicubic interpolation (Catmull-Rom): sharper than bilinear and three orders more exact on what is smooth.
///
/// fetch    as in bilinear, up to two texels outside the image. Where one of the 16 texels has the weight 0 the answer
///          is bilinear's, since a cubic needs them all.
/// returns  the colour and 1; beside a bright texel the cubic dips: what falls below zero is raised to the least of the
///          16 texels or to zero, whichever is less
template <typename Fetch>
glm::vec4 bicubic(glm::vec2 position, Fetch&& fetch) {
  const float left = std::floor(position.x - 0.5f);
  const float top = std::floor(position.y - 0.5f);
  const std::array<float, 4> across = catmullRomWeights(position.x - 0.5f - left);
  const std::array<float, 4> down = catmullRomWeights(position.y - 0.5f - top);
  glm::vec3 sum(0.0f);
  glm::vec3 least(0.0f);
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::vec4 texel =
          fetch(static_cast<int>(left) + static_cast<int>(i) - 1, static_cast<int>(top) + static_cast<int>(j) - 1);
      if (texel.w == 0.0f) return bilinear(position, fetch);
      sum += across[i] * down[j] * glm::vec3(texel);
      least = glm::min(least, glm::vec3(texel));
    }
  return glm::vec4(glm::max(sum, least), 1.0f);
}

template <typename Fetch>
glm::vec4 interpolate(Interpolation interpolation, glm::vec2 position, Fetch&& fetch) {
  return interpolation == Interpolation::bicubic ? bicubic(position, fetch) : bilinear(position, fetch);
}

}  // namespace mirrorball
