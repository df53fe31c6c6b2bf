#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/base/bit_cast.h"

namespace mirrorball {

/// Floats of 5 exponent bits (bias 15) and fewer mantissa bits than a float: half (10), and the unsigned ones of
/// b10g11r11 (6 for red and green, 5 for blue).

/// The largest finite value: 65504, 65024, 64512.
template <int kMantissaBits>
inline constexpr float kLargestSmallFloat = 65536.0f - static_cast<float>(1 << (15 - kMantissaBits));

/// The bits of the small float nearest to `size`, ties to even.
///
/// size     0 or more. What rounds beyond the largest finite value becomes infinity, NaN a quiet NaN.
template <int kMantissaBits>
inline std::uint32_t smallFloatBits(float size) {
  constexpr int kDropped = 23 - kMantissaBits;
  constexpr std::uint32_t kInfinity = 31u << kMantissaBits;
  // Halfway from the largest value to the next power of two: from here on, nearest is infinity.
  constexpr float kOverflow = 65536.0f - static_cast<float>(1 << (14 - kMantissaBits));
  const std::uint32_t bits = bitCast<std::uint32_t>(size);

  // Normal: the exponent's bias falls from 127 to 15 and the mantissa's last bits go. Adding half of what goes less
  // one, and the last bit that stays, rounds to the nearest and ties to even.
  const std::uint32_t last_bit = (bits >> kDropped) & 1u;
  const std::uint32_t normal = (bits - (112u << 23) + (1u << (kDropped - 1)) - 1u + last_bit) >> kDropped;

  // Below 2⁻¹⁴ a small float is a multiple of 2^(−14 − mantissa bits), which is the last bit of a float near
  // 2^(9 − mantissa bits): the addition rounds for us, and the multiple stands in the sum's mantissa.
  constexpr float kAligned = 512.0f / static_cast<float>(1 << kMantissaBits);
  const std::uint32_t small = bitCast<std::uint32_t>(size + kAligned) - bitCast<std::uint32_t>(kAligned);

  // All cases are computed and one selected, so that the compiler can do several at a time.
  const std::uint32_t finite = size < 0x1p-14f ? small : normal;
  const std::uint32_t bounded = size < kOverflow ? finite : kInfinity;
  return size == size ? bounded : kInfinity | (1u << (kMantissaBits - 1));
}

/// The bits of the half float nearest to `value`, ties to even.
inline std::uint16_t halfFromFloat(float value) {
  const std::uint32_t bits = bitCast<std::uint32_t>(value);
  const std::uint32_t size = smallFloatBits<10>(bitCast<float>(bits & 0x7fffffffu));
  return static_cast<std::uint16_t>(((bits >> 16) & 0x8000u) | size);
}

/// The value of a half float: exact. A small float of fewer mantissa bits is a half whose last bits are 0.
inline float floatFromHalf(std::uint16_t half) {
  // The shifted bits are a float whose exponent is too small by 112; the product is exact for denormals too.
  const float size = bitCast<float>((half & 0x7fffu) << 13) * 0x1p112f;
  const std::uint32_t special = (half & 0x7c00u) == 0x7c00u ? 0x7f800000u : 0u;
  return bitCast<float>(bitCast<std::uint32_t>(size) | special | (half & 0x8000u) << 16);
}

/// Converts floats to half floats, rounding to the nearest and ties to even; infinity and NaN stay what they are.
///
/// halves   as many as floats
/// returns  whether every finite float lies within ±65504
/// cost     about 0.15 ns a sample where the processor has the instruction (F16C), asked for once at run time
bool halvesFromFloats(std::span<const float> floats, std::span<std::uint16_t> halves);

/// The same of red, green and blue, each texel with an alpha of 1 behind it.
///
/// rgb      3 floats a texel
/// rgba     4 halves a texel
bool rgbaHalvesFromRgb(std::span<const float> rgb, std::span<std::uint16_t> rgba);

/// Converts half floats to floats.
///
/// floats   as many as halves
void floatsFromHalves(std::span<const std::uint16_t> halves, std::span<float> floats);

}  // namespace mirrorball
