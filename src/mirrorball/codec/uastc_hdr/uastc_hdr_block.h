#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "mirrorball/codec/half_blocks/block_bits.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_modes.h"

namespace mirrorball {

/// What the bits of a block say.
struct UastcHdrBlock {
  bool is_solid = false;                 ///< one colour for all texels
  std::array<std::uint16_t, 3> color{};  ///< that colour, as half floats
  std::uint8_t mode = 0;                 ///< of kUastcHdrModes
  std::uint8_t partition = 0;            ///< of kUastcHdrPartitions, where there are two subsets
  std::array<std::uint8_t, 12>
      colors{};  ///< unpackColors' bytes, of the mode's levels: of the first subset, then of the second
  std::array<std::uint8_t, 16> weights{};  ///< of weightLevels, by texels
};

/// Takes a block apart.
///
/// returns  nothing for a block of ASTC that is none of UASTC HDR, or that would not decode to finite light
std::optional<UastcHdrBlock> readUastcHdrBlock(HalfBlockBytes bytes);

/// Puts a block together.
void writeUastcHdrBlock(const UastcHdrBlock& block, std::span<std::uint8_t, kHalfBlockSize> bytes);

/// The texels of a block, by rows from the top: red, green and blue as the bits of half floats.
///
/// returns  whether it is a block of UASTC HDR; otherwise the texels are not written
/// from     Khronos Data Format Specification 1.3, chapter on ASTC
/// cost     about 0.3 µs
bool decodeUastcHdrBlock(HalfBlockBytes bytes, std::span<std::uint16_t, 48> halves);

}  // namespace mirrorball
