#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "mirrorball/codec/uastc_hdr/uastc_hdr_levels.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_modes.h"

namespace mirrorball {

/// Red, green and blue of both ends of a line, in numbers of 12 bits: nearly the logarithm of light
/// (uastc_hdr_block.h).
using ColorEnds = std::array<std::array<int, 3>, 2>;

/// The largest number of 12 bits that decodes to a finite half float: 65216.
inline constexpr int kLargestColor = 3967;

/// The ends that some bytes of a block stand for, each number from 0 to 4095.
///
/// from     Khronos Data Format Specification 1.3, ASTC: "HDR Endpoint Mode 7", "HDR Endpoint Mode 11"
ColorEnds unpackColors(ColorMode mode, std::span<const std::uint8_t> bytes);

/// Whether a decoder makes finite light of both ends.
bool areFinite(const ColorEnds& ends);

struct PackedColors {
  std::array<std::uint8_t, 6> bytes{};
  ColorEnds ends{};  ///< what they stand for
};

/// Bytes that come near to two ends, in one of these two orders: of base_and_offset the mean of them, and the mean
/// difference of their channels.
///
/// ends     0 or more; more than kLargestColor is as much as that
/// levels   that bytes can have
/// cost     about 0.05 µs
PackedColors packColors(ColorMode mode, const std::array<std::array<float, 3>, 2>& ends, const EndpointLevels& levels);

}  // namespace mirrorball
