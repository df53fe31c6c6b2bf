#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mirrorball/codec/bc6h/bc6h_modes.h"
#include "mirrorball/codec/uastc_hdr/integer_sequence.h"

namespace mirrorball {

/// The tables of UASTC HDR 4x4: those blocks of ASTC HDR that have a counterpart in BC6H. From: Binomial, "UASTC HDR
/// 4x4 Texture Specification" (Basis Universal); what ASTC's numbers mean: Khronos Data Format Specification 1.3,
/// chapter "ASTC Compressed Texture Image Formats".

/// How the two ends of a line stand in a block, by ASTC's number of the mode ("CEM").
enum class ColorMode : std::uint8_t {
  base_and_offset = 7,  ///< "HDR RGB, base + scale": one end, and how much less all channels of the other one are
  two_colors = 11,      ///< "HDR RGB, direct"
};

/// Numbers that an end's colours take.
constexpr int numbersOf(ColorMode mode) { return mode == ColorMode::two_colors ? 6 : 4; }

struct UastcHdrMode {
  ColorMode color_mode;
  int subsets;
  int weights;    ///< levels of a texel's weight
  int endpoints;  ///< levels of each number of an end's colours

  constexpr int numbers() const { return subsets * numbersOf(color_mode); }  ///< of all ends
};

/// All but the block of one colour.
inline constexpr auto kUastcHdrModes = std::to_array<UastcHdrMode>({
    {ColorMode::two_colors, 1, 3, 256},       {ColorMode::two_colors, 1, 4, 256},
    {ColorMode::two_colors, 1, 5, 256},       {ColorMode::two_colors, 1, 6, 256},
    {ColorMode::two_colors, 1, 8, 256},       {ColorMode::two_colors, 1, 10, 256},
    {ColorMode::two_colors, 1, 12, 256},      {ColorMode::two_colors, 1, 16, 192},
    {ColorMode::base_and_offset, 1, 3, 256},  {ColorMode::base_and_offset, 1, 4, 256},
    {ColorMode::base_and_offset, 1, 5, 256},  {ColorMode::base_and_offset, 1, 6, 256},
    {ColorMode::base_and_offset, 1, 8, 256},  {ColorMode::base_and_offset, 1, 10, 256},
    {ColorMode::base_and_offset, 1, 12, 256}, {ColorMode::base_and_offset, 1, 16, 256},
    {ColorMode::two_colors, 2, 3, 64},        {ColorMode::two_colors, 2, 4, 40},
    {ColorMode::base_and_offset, 2, 3, 256},  {ColorMode::base_and_offset, 2, 4, 256},
    {ColorMode::base_and_offset, 2, 5, 192},  {ColorMode::base_and_offset, 2, 6, 128},
    {ColorMode::base_and_offset, 2, 8, 80},
});

/// Bits before the ends' colours: the block's mode, subsets, partition, how colours are stored.
constexpr int uastcHdrHeaderBits(int subsets) { return subsets == 2 ? 29 : 17; }

/// ASTC stores ends in the most levels that the header and the weights leave room for: the table has none of its own.
constexpr bool uastcHdrEndpointsFill() {
  constexpr std::array<int, 9> kLevels{32, 40, 48, 64, 80, 96, 128, 160, 192};
  for (const UastcHdrMode& mode : kUastcHdrModes) {
    const int room = 128 - uastcHdrHeaderBits(mode.subsets) - sequenceBits(integerRange(mode.weights), 16);
    int most = sequenceBits(integerRange(256), mode.numbers()) <= room ? 256 : 0;
    for (const int levels : kLevels)
      if (most < levels && sequenceBits(integerRange(levels), mode.numbers()) <= room) most = levels;
    if (most != mode.endpoints) return false;
  }
  return true;
}
static_assert(uastcHdrEndpointsFill());

/// A partition that both ASTC and BC6H have.
struct UastcHdrPartition {
  std::uint16_t seed;  ///< ASTC's number
  std::uint8_t bc6h;   ///< of kBc6hPartitions
  bool is_turned;      ///< ASTC's first subset is BC6H's second one

  /// The texels of ASTC's second subset: bit x + 4 y.
  constexpr std::uint16_t second() const {
    return static_cast<std::uint16_t>(kBc6hPartitions[bc6h] ^ (is_turned ? 0xffff : 0));
  }
};
inline constexpr auto kUastcHdrPartitions = std::to_array<UastcHdrPartition>({
    {28, 0, false},  {20, 1, false},   {16, 2, true},    {29, 3, false},  {91, 4, true},   {9, 5, false},
    {107, 6, true},  {72, 7, true},    {149, 8, false},  {204, 9, true},  {50, 10, false}, {114, 11, true},
    {496, 12, true}, {17, 13, true},   {78, 14, false},  {39, 15, true},  {252, 17, true}, {828, 18, true},
    {43, 19, false}, {156, 20, false}, {116, 21, false}, {210, 22, true}, {476, 23, true}, {273, 24, false},
    {684, 25, true}, {359, 26, false}, {246, 29, true},
});

/// The texels of ASTC's second subset of two in a block of 4 × 4: the specification's "Partition Pattern Generation".
constexpr std::uint16_t astcPartition(std::uint32_t seed) {
  std::uint32_t number = seed + 1024;
  number ^= number >> 15;
  number -= number << 17;
  number += number << 7;
  number += number << 4;
  number ^= number >> 5;
  number += number << 16;
  number ^= number >> 7;
  number ^= number >> 3;
  number ^= number << 6;
  number ^= number >> 17;
  const unsigned odd_shift = seed & 1u ? (seed & 2u ? 4u : 5u) : 5u;
  const unsigned even_shift = seed & 1u ? 5u : (seed & 2u ? 4u : 5u);
  std::array<std::uint32_t, 4> slopes{};
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t slope = number >> 4 * i & 15u;
    slopes[i] = slope * slope >> (i % 2 == 0 ? odd_shift : even_shift);
  }
  std::uint16_t second = 0;
  for (unsigned texel = 0; texel < 16; ++texel) {
    const unsigned x = texel % 4 * 2;  // small blocks are stretched
    const unsigned y = texel / 4 * 2;
    const unsigned a = (slopes[0] * x + slopes[1] * y + (number >> 14)) & 63u;
    const unsigned b = (slopes[2] * x + slopes[3] * y + (number >> 10)) & 63u;
    if (a < b) second = static_cast<std::uint16_t>(second | 1u << texel);
  }
  return second;
}

constexpr bool uastcHdrPartitionsAreAstcs() {
  for (const UastcHdrPartition& partition : kUastcHdrPartitions)
    if (astcPartition(partition.seed) != partition.second()) return false;
  return true;
}
static_assert(uastcHdrPartitionsAreAstcs());

}  // namespace mirrorball
