#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "mirrorball/codec/bc6h/bc6h_modes.h"

namespace mirrorball {

/// What the bits of a block say.
struct Bc6hBlock {
  int mode = 0;       ///< of kBc6hModes
  int partition = 0;  ///< of kBc6hPartitions, where there are two subsets
  /// Red, green and blue of both ends of the first and of the second subset, with the bits that the mode has.
  std::array<int, 12> endpoints{};
  std::array<std::uint8_t, 16> indices{};
};

/// Takes a block apart.
///
/// returns  nothing for one of the four codes that are reserved
std::optional<Bc6hBlock> readBc6hBlock(std::span<const std::uint8_t, kBc6hBlockSize> bytes, bool is_signed);

/// Puts an unsigned block together.
///
/// block    ends that the mode can hold; an anchor's index is in the lower half
void writeBc6hBlock(const Bc6hBlock& block, std::span<std::uint8_t, kBc6hBlockSize> bytes);

/// The texels of a block, by rows from the top: red, green and blue as the bits of half floats. Those of a reserved
/// mode are 0.
///
/// from     Khronos Data Format Specification 1.3, "BC6H"
/// cost     about 0.4 µs
void decodeBc6hBlock(std::span<const std::uint8_t, kBc6hBlockSize> bytes, bool is_signed,
                     std::span<std::uint16_t, 48> halves);

}  // namespace mirrorball
