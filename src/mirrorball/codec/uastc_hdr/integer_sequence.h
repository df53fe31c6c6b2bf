#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/codec/half_blocks/block_bits.h"

namespace mirrorball {

/// ASTC's bounded integer sequence encoding: each number is some bits, and a digit of base 3 or 5 above them, of which
/// five (trits) or three (quints) share 8 or 7 bits. From: Khronos Data Format Specification 1.3, section "Integer
/// Sequence Encoding" of the chapter on ASTC.
struct IntegerRange {
  int base = 1;  ///< 1, 3 or 5
  int bits = 0;  ///< of each number

  constexpr int levels() const { return base << bits; }
};

/// The range of so many levels: a power of two, or three or five times one.
constexpr IntegerRange integerRange(int levels) {
  IntegerRange range{.base = levels % 3 == 0 ? 3 : levels % 5 == 0 ? 5 : 1};
  for (int rest = levels / range.base; rest > 1; rest /= 2) ++range.bits;
  return range;
}

/// Bits of a sequence of so many numbers.
constexpr int sequenceBits(IntegerRange range, int count) {
  const int digits = range.base == 3 ? (8 * count + 4) / 5 : range.base == 5 ? (7 * count + 2) / 3 : 0;
  return count * range.bits + digits;
}

/// Reads a sequence: numbers of the range.
void readIntegerSequence(BlockBitReader& bits, IntegerRange range, std::span<std::uint8_t> numbers);

/// Writes one.
void writeIntegerSequence(BlockBitWriter& bits, IntegerRange range, std::span<const std::uint8_t> numbers);

}  // namespace mirrorball
