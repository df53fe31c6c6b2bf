#pragma once

#include <algorithm>
#include <cstdint>

#include <glm/vec3.hpp>

#include "mirrorball/base/bit_cast.h"

namespace mirrorball {

/// The largest value of e5b9g9r9: 511/512 · 2¹⁶.
inline constexpr float kLargestSharedExponent = 65408.0f;

/// 2^exponent, for −126 … 127.
inline float powerOfTwo(int exponent) { return bitCast<float>(static_cast<std::uint32_t>(exponent + 127) << 23); }

/// Packs three values into 9 bits each with a common exponent of 5 bits: red in the lowest bits, the exponent on top.
///
/// color    each in [0, kLargestSharedExponent]
/// from     EXT_texture_shared_exponent, "Encoding of RGB9_E5": N = 9, B = 15, Emax = 31
inline std::uint32_t sharedExponentFromColor(glm::vec3 color) {
  constexpr int kBias = 15;
  constexpr int kMantissaBits = 9;
  // Components are rounded to the nearest, halves up. A fraction is exact, where adding ½ would not be.
  const auto rounded = [](float size) {
    const auto whole = static_cast<std::uint32_t>(size);
    return whole + (size - static_cast<float>(whole) >= 0.5f ? 1u : 0u);
  };
  const float brightest = std::max({color.x, color.y, color.z});
  const int floor_log2 = static_cast<int>(bitCast<std::uint32_t>(brightest) >> 23) - 127;
  int exponent = std::max(-kBias - 1, floor_log2) + 1 + kBias;
  float scale = powerOfTwo(kBias + kMantissaBits - exponent);
  // Rounding may carry the brightest mantissa to 2⁹: then the exponent is one more.
  if (rounded(brightest * scale) == 1u << kMantissaBits) {
    ++exponent;
    scale *= 0.5f;
  }
  return rounded(color.x * scale) | rounded(color.y * scale) << 9 | rounded(color.z * scale) << 18 |
         static_cast<std::uint32_t>(exponent) << 27;
}

/// What the 32 bits stand for: mantissa · 2^(exponent − 15 − 9).
inline glm::vec3 colorFromSharedExponent(std::uint32_t bits) {
  const float unit = powerOfTwo(static_cast<int>(bits >> 27) - 24);
  const auto component = [&](int shift) { return static_cast<float>((bits >> shift) & 0x1ffu) * unit; };
  return {component(0), component(9), component(18)};
}

}  // namespace mirrorball
