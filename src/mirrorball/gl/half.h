#pragma once

#include <cstdint>
#include <span>

namespace mirrorball::gl {

constexpr float kLargestHalf = 65504.0f;

/// Converts a row of floats to half floats (IEEE 754 binary16), rounding to the nearest and ties to
/// even. Beyond ±65504, the largest half, it clamps; NaN becomes that too, with an unknown sign.
///
/// halves   as many as floats
void halvesFromFloats(std::span<const float> floats, std::span<std::uint16_t> halves);

}  // namespace mirrorball::gl
