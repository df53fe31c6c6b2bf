#include "mirrorball/gl/half.h"

#include <bit>
#include <cassert>
#include <cstddef>

namespace mirrorball::gl {
namespace {

// Both cases are computed and one selected, so that the compiler can do several at a time.
inline std::uint16_t halfFromFloat(float value) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = (bits >> 16) & 0x8000u;
  const float size = std::bit_cast<float>(bits & 0x7fffffffu);
  const float clamped = size < 65504.0f ? size : 65504.0f;
  const std::uint32_t clamped_bits = std::bit_cast<std::uint32_t>(clamped);

  // A normal half: the exponent's bias falls from 127 to 15 and 13 bits of the mantissa go. Adding
  // half of what goes less one, and the last bit that stays, rounds to the nearest and ties to
  // even.
  const std::uint32_t last_bit = (clamped_bits >> 13) & 1u;
  const std::uint32_t normal = (clamped_bits - (112u << 23) + 0xfffu + last_bit) >> 13;

  // Below 2⁻¹⁴ a half is a multiple of 2⁻²⁴, which is the last bit of a float near ½: the addition
  // rounds for us, and the multiple stands in the sum's mantissa.
  const std::uint32_t small = std::bit_cast<std::uint32_t>(clamped + 0.5f) - 0x3f000000u;

  return static_cast<std::uint16_t>(sign | (clamped_bits < (113u << 23) ? small : normal));
}

}  // namespace

void halvesFromFloats(std::span<const float> floats, std::span<std::uint16_t> halves) {
  assert(floats.size() == halves.size());
  for (std::size_t i = 0; i < floats.size(); ++i) halves[i] = halfFromFloat(floats[i]);
}

}  // namespace mirrorball::gl
