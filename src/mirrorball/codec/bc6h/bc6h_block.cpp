#include "mirrorball/codec/bc6h/bc6h_block.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "mirrorball/codec/half_blocks/block_bits.h"

namespace mirrorball {
namespace {

/// The mode of each code of five bits, or −1. Those of two bits stand for all whose lowest two are theirs.
constexpr std::array<int, 32> modesByCode() {
  std::array<int, 32> modes{};
  for (int code = 0; code < 32; ++code) {
    modes[std::size_t(code)] = -1;
    for (std::size_t mode = 0; mode < kBc6hModes.size(); ++mode)
      if ((code & ((1 << kBc6hModes[mode].code_bits) - 1)) == kBc6hModes[mode].code)
        modes[std::size_t(code)] = static_cast<int>(mode);
  }
  return modes;
}
constexpr std::array<int, 32> kModesByCode = modesByCode();

int signExtended(int value, int bits) {
  const int sign = 1 << (bits - 1);
  return (value ^ sign) - sign;
}

bool isAnchor(const Bc6hMode& mode, int partition, std::size_t texel) {
  return texel == 0 || (mode.subsets == 2 && texel == kBc6hAnchors[std::size_t(partition)]);
}

/// Turns what stands in the block into the ends themselves.
void resolveEndpoints(const Bc6hMode& mode, bool is_signed, std::array<int, 12>& endpoints) {
  if (is_signed)
    for (std::size_t c = 0; c < 3; ++c) endpoints[c] = signExtended(endpoints[c], mode.bits);
  for (std::size_t i = 3; i < 6 * std::size_t(mode.subsets); ++i) {
    int& end = endpoints[i];
    if (is_signed || mode.is_delta) end = signExtended(end, mode.bitsOf(i));
    if (!mode.is_delta) continue;
    end = (endpoints[i % 3] + end) & ((1 << mode.bits) - 1);
    if (is_signed) end = signExtended(end, mode.bits);
  }
}

/// Spreads the numbers of `bits` bits over those of 16.
int unquantized(int value, int bits, bool is_signed) {
  if (!is_signed) {
    if (bits >= 15 || value == 0) return value;
    if (value == (1 << bits) - 1) return 0xffff;
    return ((value << 15) + 0x4000) >> (bits - 1);
  }
  if (bits >= 16 || value == 0) return value;
  const int size = value < 0 ? -value : value;
  const int spread = size >= (1 << (bits - 1)) - 1 ? 0x7fff : ((size << 15) + 0x4000) >> (bits - 1);
  return value < 0 ? -spread : spread;
}

/// 31/64 of an unsigned number and 31/32 of a signed one are a half float's bits: the largest is 65504.
std::uint16_t halfOf(int value, bool is_signed) {
  if (!is_signed) return static_cast<std::uint16_t>((value * 31) >> 6);
  return static_cast<std::uint16_t>(value < 0 ? 0x8000 | ((-value * 31) >> 5) : (value * 31) >> 5);
}

}  // namespace

std::optional<Bc6hBlock> readBc6hBlock(HalfBlockBytes bytes, bool is_signed) {
  Bc6hBlock block;
  block.mode = kModesByCode[bytes[0] & 31u];
  if (block.mode < 0) return {};
  const Bc6hMode& mode = kBc6hModes[std::size_t(block.mode)];
  BlockBitReader bits(BlockBits::of(bytes));
  bits.take(mode.code_bits);
  for (std::size_t i = 0; i < mode.run_count; ++i) {
    const Bc6hRun& run = mode.runs[i];
    block.endpoints[run.channel] |= static_cast<int>(bits.take(run.count)) << run.low;
  }
  if (mode.subsets == 2) block.partition = static_cast<int>(bits.take(5));
  for (std::size_t texel = 0; texel < 16; ++texel)
    block.indices[texel] = static_cast<std::uint8_t>(
        bits.take(bc6hIndexBits(mode.subsets) - (isAnchor(mode, block.partition, texel) ? 1 : 0)));
  resolveEndpoints(mode, is_signed, block.endpoints);
  return block;
}

void writeBc6hBlock(const Bc6hBlock& block, std::span<std::uint8_t, kBc6hBlockSize> bytes) {
  const Bc6hMode& mode = kBc6hModes[std::size_t(block.mode)];
  std::array<int, 12> stored = block.endpoints;
  for (std::size_t i = 3; i < 12 && mode.is_delta; ++i) stored[i] -= stored[i % 3];
  BlockBitWriter bits;
  bits.put(static_cast<std::uint32_t>(mode.code), mode.code_bits);
  for (std::size_t i = 0; i < mode.run_count; ++i) {
    const Bc6hRun& run = mode.runs[i];
    bits.put(static_cast<std::uint32_t>(stored[run.channel]) >> run.low, run.count);
  }
  if (mode.subsets == 2) bits.put(static_cast<std::uint32_t>(block.partition), 5);
  for (std::size_t texel = 0; texel < 16; ++texel)
    bits.put(block.indices[texel], bc6hIndexBits(mode.subsets) - (isAnchor(mode, block.partition, texel) ? 1 : 0));
  assert(bits.count() == 128);
  bits.bits().store(bytes);
}

void decodeBc6hBlock(HalfBlockBytes bytes, bool is_signed, std::span<std::uint16_t, 48> halves) {
  const std::optional<Bc6hBlock> block = readBc6hBlock(bytes, is_signed);
  if (!block) {
    std::fill(halves.begin(), halves.end(), std::uint16_t{0});
    return;
  }
  const Bc6hMode& mode = kBc6hModes[std::size_t(block->mode)];
  std::array<int, 12> ends;
  for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = unquantized(block->endpoints[i], mode.bits, is_signed);
  const unsigned second = mode.subsets == 2 ? kBc6hPartitions[std::size_t(block->partition)] : 0u;
  for (std::size_t texel = 0; texel < 16; ++texel) {
    const int* const end = ends.data() + (second >> texel & 1u) * 6;
    const int weight = bc6hWeight(block->indices[texel], bc6hIndexBits(mode.subsets));
    for (std::size_t c = 0; c < 3; ++c)
      halves[3 * texel + c] = halfOf((end[c] * (64 - weight) + end[c + 3] * weight + 32) >> 6, is_signed);
  }
}

}  // namespace mirrorball
