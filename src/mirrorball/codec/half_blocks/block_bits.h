#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mirrorball/codec/byte_order.h"

namespace mirrorball {

inline constexpr std::size_t kHalfBlockSize = 16;  ///< bytes of a compressed block of half floats

using HalfBlockBytes = std::span<const std::uint8_t, kHalfBlockSize>;

/// The 128 bits of a block, the lowest first.
struct BlockBits {
  std::uint64_t low = 0;
  std::uint64_t high = 0;

  static BlockBits of(HalfBlockBytes bytes) { return {littleU64(bytes.data()), littleU64(bytes.data() + 8)}; }

  void store(std::span<std::uint8_t, kHalfBlockSize> bytes) const {
    for (std::size_t i = 0; i < bytes.size(); ++i)
      bytes[i] = static_cast<std::uint8_t>((i < 8 ? low : high) >> 8 * (i % 8));
  }

  friend BlockBits operator|(BlockBits a, BlockBits b) { return {a.low | b.low, a.high | b.high}; }
};

/// Takes the lowest bits of those that are left.
class BlockBitReader {
 public:
  explicit BlockBitReader(BlockBits bits) : bits_(bits) {}

  /// 0 to 31 bits; 0 where none are left.
  std::uint32_t take(int count) {
    const auto taken = static_cast<std::uint32_t>(bits_.low & ((std::uint64_t{1} << count) - 1));
    // In two steps, since no shift by 64 is defined.
    bits_.low = bits_.low >> count | bits_.high << 1 << (63 - count);
    bits_.high >>= count;
    return taken;
  }

 private:
  BlockBits bits_;
};

/// Puts bits above those that are there.
class BlockBitWriter {
 public:
  /// 0 to 31 of the lowest bits; what is above them does not matter.
  void put(std::uint32_t bits, int count) {
    assert(at_ + count <= 128);
    const std::uint64_t value = bits & ((std::uint64_t{1} << count) - 1);
    if (at_ < 64) {
      bits_.low |= value << at_;
      bits_.high |= value >> 1 >> (63 - at_);
    } else if (count > 0) {
      bits_.high |= value << (at_ - 64);
    }
    at_ += count;
  }

  int count() const { return at_; }
  BlockBits bits() const { return bits_; }

 private:
  BlockBits bits_;
  int at_ = 0;  // of the next bit
};

}  // namespace mirrorball
