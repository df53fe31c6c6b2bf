#pragma once

#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace mirrorball {

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

}  // namespace mirrorball
