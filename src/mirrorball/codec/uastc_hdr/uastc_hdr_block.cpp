#include "mirrorball/codec/uastc_hdr/uastc_hdr_block.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "mirrorball/codec/uastc_hdr/uastc_hdr_colors.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_levels.h"

namespace mirrorball {
namespace {

// A block of one colour, "void extent": its kind, then four coordinates of 13 bits within which the picture has it too,
// all ones where nothing is said of that.
constexpr std::uint32_t kSolid = 0x1fc;      // 9 bits
constexpr std::uint32_t kSolidOfHalves = 7;  // 3 bits: half floats, and two that are always 1
constexpr std::uint64_t kNoExtent = (std::uint64_t{1} << 52) - 1;
constexpr std::uint32_t kOpaque = 0x3c00;        // alpha: 1 as a half float
constexpr std::uint32_t kFirstSpecial = 0x7c00;  // infinity, then NaN, then what is negative

/// The upper bits of a block's mode for weights of 4 × 4 texels, one plane of them.
constexpr std::uint32_t kGridOfFour = 2u << 5;

/// The range of weights as the mode has it, by how many levels there are: three bits and one above.
constexpr std::array<int, 16> kWeightCounts{0, 0, 2, 3, 4, 5, 6, 8, 0, 0, 10, 12, 16, 20, 24, 32};

/// The eleven bits of a block's mode.
std::uint32_t blockModeOf(int weights) {
  const auto range = static_cast<std::uint32_t>(std::find(kWeightCounts.begin(), kWeightCounts.end(), weights) -
                                                kWeightCounts.begin());
  return kGridOfFour | (range >> 1 & 3u) | (range & 1u) << 4 | (range >> 3) << 9;
}

/// The levels of the weights, or 0 where the weights are no grid of 4 × 4 or have two planes.
int weightsOf(std::uint32_t block_mode) {
  constexpr std::uint32_t kRangeBits = 1u << 9 | 1u << 4 | 3u;
  if ((block_mode & ~kRangeBits) != kGridOfFour || (block_mode & 3u) == 0) return 0;
  return kWeightCounts[(block_mode >> 9) << 3 | (block_mode & 3u) << 1 | (block_mode >> 4 & 1u)];
}

std::uint64_t turned(std::uint64_t bits) {
  std::uint64_t result = 0;
  for (int i = 0; i < 64; ++i) result = result << 1 | (bits >> i & 1u);
  return result;
}

/// Weights begin at the block's last bit and go down.
BlockBits turned(BlockBits bits) { return {turned(bits.high), turned(bits.low)}; }

/// Whether the coordinates are all ones, or each first one is less than the last.
bool isExtent(std::uint64_t coordinates) {
  const auto at = [&](int i) { return coordinates >> 13 * i & 0x1fffu; };
  return coordinates == kNoExtent || (at(0) < at(1) && at(2) < at(3));
}

std::optional<UastcHdrBlock> readSolidBlock(BlockBits bits) {
  if ((bits.low >> 9 & 7u) != kSolidOfHalves || !isExtent(bits.low >> 12)) return {};
  UastcHdrBlock block{.is_solid = true};
  for (std::size_t c = 0; c < 3; ++c) {
    block.color[c] = static_cast<std::uint16_t>(bits.high >> 16 * c);
    if (block.color[c] >= kFirstSpecial) return {};
  }
  return block;
}

/// The bytes of a mode's colours as they are counted in the block.
std::span<std::uint8_t> colorsOf(const UastcHdrMode& mode, std::array<std::uint8_t, 12>& colors) {
  return std::span(colors).first(std::size_t(mode.numbers()));
}

bool areColorsFinite(const UastcHdrMode& mode, const UastcHdrBlock& block) {
  const auto step = static_cast<std::size_t>(numbersOf(mode.color_mode));
  for (std::size_t subset = 0; subset < std::size_t(mode.subsets); ++subset)
    if (!areFinite(unpackColors(mode.color_mode, std::span(block.colors).subspan(subset * step, step)))) return false;
  return true;
}

/// The bits of the half float that a number of 16 bits stands for: 5 of exponent, then a mantissa that rises by a curve
/// near to the logarithm of light. From: Khronos Data Format Specification 1.3, ASTC: "Weight Application".
std::uint16_t halfOfNumber(int number) {
  const int exponent = number >> 11;
  const int mantissa = number & 0x7ff;
  const int straight = mantissa < 512 ? 3 * mantissa : mantissa < 1536 ? 4 * mantissa - 512 : 5 * mantissa - 2048;
  return static_cast<std::uint16_t>((exponent << 10) + (straight >> 3));
}

}  // namespace

std::optional<UastcHdrBlock> readUastcHdrBlock(HalfBlockBytes bytes) {
  const BlockBits all = BlockBits::of(bytes);
  if ((all.low & 0x1ffu) == kSolid) return readSolidBlock(all);
  BlockBitReader bits(all);
  const int weights = weightsOf(bits.take(11));
  const int subsets = static_cast<int>(bits.take(2)) + 1;
  UastcHdrBlock block;
  if (subsets == 2) {
    const std::uint32_t seed = bits.take(10);
    const auto* const found = std::find_if(kUastcHdrPartitions.begin(), kUastcHdrPartitions.end(),
                                           [&](const UastcHdrPartition& partition) { return partition.seed == seed; });
    // Both subsets' colours must be stored in the same way, which two bits of 0 say.
    if (found == kUastcHdrPartitions.end() || bits.take(2) != 0) return {};
    block.partition = static_cast<std::uint8_t>(found - kUastcHdrPartitions.begin());
  }
  const auto color_mode = static_cast<ColorMode>(bits.take(4));
  const auto* const found = std::find_if(kUastcHdrModes.begin(), kUastcHdrModes.end(), [&](const UastcHdrMode& mode) {
    return mode.color_mode == color_mode && mode.subsets == subsets && mode.weights == weights;
  });
  if (found == kUastcHdrModes.end()) return {};
  block.mode = static_cast<std::uint8_t>(found - kUastcHdrModes.begin());

  const std::span<std::uint8_t> colors = colorsOf(*found, block.colors);
  readIntegerSequence(bits, integerRange(found->endpoints), colors);
  const EndpointLevels& levels = endpointLevels(found->endpoints);
  for (std::uint8_t& color : colors) color = levels.values[color];
  if (!areColorsFinite(*found, block)) return {};

  BlockBitReader weight_bits(turned(all));
  readIntegerSequence(weight_bits, integerRange(weights), block.weights);
  const WeightLevels& ascending = weightLevels(weights);
  for (std::uint8_t& weight : block.weights)
    weight = static_cast<std::uint8_t>(std::find(ascending.numbers.begin(), ascending.numbers.end(), weight) -
                                       ascending.numbers.begin());
  return block;
}

void writeUastcHdrBlock(const UastcHdrBlock& block, std::span<std::uint8_t, kHalfBlockSize> bytes) {
  if (block.is_solid) {
    BlockBits bits{kSolid | std::uint64_t{kSolidOfHalves} << 9 | kNoExtent << 12, std::uint64_t{kOpaque} << 48};
    for (std::size_t c = 0; c < 3; ++c) bits.high |= std::uint64_t{block.color[c]} << 16 * c;
    bits.store(bytes);
    return;
  }
  const UastcHdrMode& mode = kUastcHdrModes[block.mode];
  BlockBitWriter bits;
  bits.put(blockModeOf(mode.weights), 11);
  bits.put(static_cast<std::uint32_t>(mode.subsets - 1), 2);
  if (mode.subsets == 2) {
    bits.put(kUastcHdrPartitions[block.partition].seed, 10);
    bits.put(0, 2);
  }
  bits.put(static_cast<std::uint32_t>(mode.color_mode), 4);
  assert(bits.count() == uastcHdrHeaderBits(mode.subsets));
  std::array<std::uint8_t, 12> numbers = block.colors;
  const EndpointLevels& levels = endpointLevels(mode.endpoints);
  for (std::uint8_t& number : numbers) number = levels.numbers[number];
  writeIntegerSequence(bits, integerRange(mode.endpoints), colorsOf(mode, numbers));

  std::array<std::uint8_t, 16> weights;
  for (std::size_t i = 0; i < 16; ++i) weights[i] = weightLevels(mode.weights).numbers[block.weights[i]];
  BlockBitWriter weight_bits;
  writeIntegerSequence(weight_bits, integerRange(mode.weights), weights);
  assert(bits.count() + weight_bits.count() <= 128);
  (bits.bits() | turned(weight_bits.bits())).store(bytes);
}

bool decodeUastcHdrBlock(HalfBlockBytes bytes, std::span<std::uint16_t, 48> halves) {
  const std::optional<UastcHdrBlock> block = readUastcHdrBlock(bytes);
  if (!block) return false;
  if (block->is_solid) {
    for (std::size_t i = 0; i < halves.size(); ++i) halves[i] = block->color[i % 3];
    return true;
  }
  const UastcHdrMode& mode = kUastcHdrModes[block->mode];
  const auto step = static_cast<std::size_t>(numbersOf(mode.color_mode));
  std::array<ColorEnds, 2> lines;
  for (std::size_t subset = 0; subset < std::size_t(mode.subsets); ++subset)
    lines[subset] = unpackColors(mode.color_mode, std::span(block->colors).subspan(subset * step, step));
  const unsigned second = mode.subsets == 2 ? kUastcHdrPartitions[block->partition].second() : 0u;
  const WeightLevels& levels = weightLevels(mode.weights);
  for (std::size_t texel = 0; texel < 16; ++texel) {
    const ColorEnds& ends = lines[second >> texel & 1u];
    const int share = levels.shares[block->weights[texel]];
    for (std::size_t c = 0; c < 3; ++c)
      halves[3 * texel + c] = halfOfNumber((16 * ends[0][c] * (64 - share) + 16 * ends[1][c] * share + 32) >> 6);
  }
  return true;
}

}  // namespace mirrorball
