#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace mirrorball {

/// Interpolation between texels.
enum class Interpolation { bilinear, bicubic };

/// Bilinear interpolation at a continuous position, texel (i, j) having its centre at (i + ½, j + ½).
///
/// position in texels from the image's top left corner
/// fetch    vec4 fetch(int x, int y): a texel that may lie one outside the image, by the caller's rule for edges. Its
///          fourth component is its weight: a texel of weight 0 is left out, and the others are scaled up.
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

/// Texels that a curve runs through, in each channel.
struct TexelRange {
  glm::vec3 min;
  glm::vec3 max;
};

/// How many times brighter the brightest of some texels is than the darkest, in the channel where that is most. In a
/// channel nearly without light only what is more than 1/64 of the brightest counts.
inline float contrastOf(const TexelRange& all) {
  const float little = std::max({all.max.x, all.max.y, all.max.z, 0.0f}) / 64.0f;
  const glm::vec3 contrasts = (glm::abs(all.max) + little) / glm::max(all.min + little, 1e-30f);
  return std::max({contrasts.x, contrasts.y, contrasts.z});
}

/// 1 up to half of a contrast, falling to 0 at the whole of it.
inline float shareBelow(float whole, float contrast) {
  return std::min(std::max(2.0f - 2.0f / whole * contrast, 0.0f), 1.0f);
}

/// From this contrast on nothing is kept of a curve's deviation from the straight line.
constexpr float kCubicContrast = 16.0f;

/// The share that is kept of a curve's deviation from the straight line, if the texels that it runs through differ like
/// these: all of it up to a contrast of 8 within a channel, none of it from 16 on. At such a contrast, beside a sun or
/// at its edge, a smooth curve swings far below the dark texels. Clamping it there would add light (17 % for a single
/// texel); the straight line keeps the sum. One share is used for all channels, otherwise edges would have coloured
/// fringes.
///
/// returns  in [0, 1]
inline float shareByContrast(const TexelRange& all) { return shareBelow(kCubicContrast, contrastOf(all)); }

/// The value of a cubic at a place, and the share that contrast leaves of a curve that crosses it there.
struct LimitedCubic {
  glm::vec3 light;
  float crossing_share;  ///< an outer texel's contrast counts less the farther it is: no jumps from cell to cell
};

/// The cubic through texels[1] and texels[2], at t in [0, 1] between them, that has at each the slope of the chord of
/// its neighbours (Catmull and Rom 1974), kept from ringing. Exact on parabolas of little contrast.
///
/// It lies −t (1 − t) ((1 − t) h₁ + t h₂) from the straight line, where h are half the second differences at the two.
/// It stays in the range of the two, except for a peak or a trough between them, where both bend one way and both
/// neighbours lie on that side: there, as far outside as the least of those four differences allows, and never below
/// zero.
///
/// max_share   of its deviation from the straight line that may be kept
/// line_bend   what takes the straight line's place is at t + line_bend · t (1 − t) on it: where texels grow from one
///             to the next, as a panorama's rows do, a straight line would give the light of one to the other
inline LimitedCubic limitedCubic(const std::array<glm::vec3, 4>& texels, float t, float max_share = 1.0f,
                                 float line_bend = 0.0f) {
  const auto& [before, first, second, after] = texels;
  const glm::vec3 half_slope = 0.5f * (second - first);
  const glm::vec3 from_first = before - first;
  const glm::vec3 from_second = after - second;
  const glm::vec3 bend = 0.5f * from_first + half_slope;
  const glm::vec3 next_bend = 0.5f * from_second - half_slope;
  const float arch = t - t * t;
  const glm::vec3 change = -arch * ((1.0f - t) * bend + t * next_bend);

  const TexelRange both{glm::min(first, second), glm::max(first, second)};
  const auto shareAmong = [&both](glm::vec3 one, glm::vec3 other) {
    return shareByContrast({glm::min(both.min, glm::min(one, other)), glm::max(both.max, glm::max(one, other))});
  };
  const float share = max_share * shareAmong(before, after);
  const glm::vec3 line = first + (t + (1.0f - share) * line_bend * arch) * (second - first);
  const glm::vec3 trough = glm::max(glm::min(glm::min(bend, next_bend), glm::min(from_first, from_second)), 0.0f);
  const glm::vec3 peak = -glm::min(glm::max(glm::max(bend, next_bend), glm::max(from_first, from_second)), 0.0f);
  const TexelRange range{glm::max(both.min - 2.0f * arch * trough, glm::min(both.min, 0.0f)),
                         both.max + 2.0f * arch * peak};
  return {glm::clamp(line + share * change, range.min, range.max),
          shareAmong(first + (1.0f - t) * from_first, second + t * from_second)};
}

/// Bicubic interpolation (Catmull-Rom down the columns, then across): sharper than bilinear and three orders more exact
/// on what is smooth. Where light jumps it turns into bilinear interpolation, as limitedCubic does.
///
/// fetch    as in bilinear, up to two texels outside the image. Where one of the 16 texels has the weight 0 the answer
///          is bilinear's, since a cubic needs them all.
/// row_bend limitedCubic's line_bend, down the columns
/// returns  the colour and 1. Grey texels give grey; nothing is darker or brighter than the texels around, except at
///          smooth peaks, by at most a quarter of the smaller second difference.
template <typename Fetch>
glm::vec4 bicubic(glm::vec2 position, Fetch&& fetch, float row_bend = 0.0f) {
  const float left = std::floor(position.x - 0.5f);
  const float top = std::floor(position.y - 0.5f);
  std::array<glm::vec3, 4> columns;
  float min_share = 1.0f;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<glm::vec3, 4> column;
    for (std::size_t j = 0; j < 4; ++j) {
      const glm::vec4 texel =
          fetch(static_cast<int>(left) + static_cast<int>(i) - 1, static_cast<int>(top) + static_cast<int>(j) - 1);
      if (texel.w == 0.0f) return bilinear(position, fetch);
      column[j] = glm::vec3(texel);
    }
    const LimitedCubic down = limitedCubic(column, position.y - 0.5f - top, 1.0f, row_bend);
    columns[i] = down.light;
    min_share = std::min(min_share, down.crossing_share);
  }
  return glm::vec4(limitedCubic(columns, position.x - 0.5f - left, min_share).light, 1.0f);
}

}  // namespace mirrorball
