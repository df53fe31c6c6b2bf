#include "mirrorball/codec/uastc_hdr/integer_sequence.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace mirrorball {
namespace {

using Digits = std::array<std::uint8_t, 5>;

/// The digits of base 3 in 8 bits.
constexpr Digits trits(unsigned t) {
  unsigned t4 = 2;
  unsigned t3 = 2;
  unsigned c = (t >> 5) << 2 | (t & 3u);
  if ((t >> 2 & 7u) != 7u) {
    c = t & 31u;
    const bool is_two = (t >> 5 & 3u) == 3u;
    t4 = is_two ? 2u : t >> 7;
    t3 = is_two ? t >> 7 : t >> 5 & 3u;
  }
  unsigned t2 = 2;
  unsigned t1 = 2;
  unsigned t0 = c & 3u;
  if ((c & 3u) == 3u) {
    t1 = c >> 4;
    t0 = (c >> 3 & 1u) << 1 | (c >> 2 & ~(c >> 3) & 1u);
  } else if ((c >> 2 & 3u) != 3u) {
    t2 = c >> 4;
    t1 = c >> 2 & 3u;
    t0 = (c >> 1 & 1u) << 1 | (c & ~(c >> 1) & 1u);
  }
  return {static_cast<std::uint8_t>(t0), static_cast<std::uint8_t>(t1), static_cast<std::uint8_t>(t2),
          static_cast<std::uint8_t>(t3), static_cast<std::uint8_t>(t4)};
}

/// The digits of base 5 in 7 bits.
constexpr Digits quints(unsigned q) {
  if ((q >> 1 & 3u) == 3u && (q >> 5 & 3u) == 0u) {
    const unsigned not_first = ~q & 1u;
    const unsigned q2 = (q & 1u) << 2 | (q >> 4 & not_first) << 1 | (q >> 3 & not_first);
    return {4, 4, static_cast<std::uint8_t>(q2)};
  }
  unsigned q2 = q >> 5 & 3u;
  unsigned c = q & 31u;
  if ((q >> 1 & 3u) == 3u) {
    q2 = 4;
    c = (q >> 3 & 3u) << 3 | (~(q >> 5) & 3u) << 1 | (q & 1u);
  }
  const bool is_four = (c & 7u) == 5u;
  const unsigned q1 = is_four ? 4u : c >> 3 & 3u;
  const unsigned q0 = is_four ? c >> 3 & 3u : c & 7u;
  return {static_cast<std::uint8_t>(q0), static_cast<std::uint8_t>(q1), static_cast<std::uint8_t>(q2)};
}

/// How digits are packed together.
struct Packing {
  std::size_t digits;  // of a group
  int base;
  std::array<int, 5> bits;        // of the group's code, behind each number's own bits
  std::array<Digits, 256> codes;  // the digits of each code
  std::array<std::uint8_t, 243> code_of;
};

constexpr std::size_t placeOf(const Digits& digits, std::size_t count, int base) {
  std::size_t place = 0;
  for (std::size_t i = count; i-- > 0;) place = place * std::size_t(base) + digits[i];
  return place;
}

/// Several codes mean the same digits. The least has no bits where a sequence that ends within the group has none.
constexpr Packing packing(std::size_t digits, int base, std::array<int, 5> bits, unsigned codes) {
  Packing made{digits, base, bits, {}, {}};
  for (unsigned code = codes; code-- > 0;) {
    made.codes[code] = base == 3 ? trits(code) : quints(code);
    made.code_of[placeOf(made.codes[code], digits, base)] = static_cast<std::uint8_t>(code);
  }
  return made;
}
constexpr Packing kTrits = packing(5, 3, {2, 2, 1, 2, 1}, 256);
constexpr Packing kQuints = packing(3, 5, {3, 2, 2, 0, 0}, 128);

}  // namespace

void readIntegerSequence(BlockBitReader& bits, IntegerRange range, std::span<std::uint8_t> numbers) {
  if (range.base == 1) {
    for (std::uint8_t& number : numbers) number = static_cast<std::uint8_t>(bits.take(range.bits));
    return;
  }
  const Packing& packing = range.base == 3 ? kTrits : kQuints;
  for (; !numbers.empty(); numbers = numbers.subspan(std::min(packing.digits, numbers.size()))) {
    const std::span<std::uint8_t> group = numbers.first(std::min(packing.digits, numbers.size()));
    unsigned code = 0;
    int at = 0;
    for (std::size_t i = 0; i < group.size(); ++i) {
      group[i] = static_cast<std::uint8_t>(bits.take(range.bits));
      code |= bits.take(packing.bits[i]) << at;
      at += packing.bits[i];
    }
    for (std::size_t i = 0; i < group.size(); ++i)
      group[i] = static_cast<std::uint8_t>(packing.codes[code][i] << range.bits | group[i]);
  }
}

void writeIntegerSequence(BlockBitWriter& bits, IntegerRange range, std::span<const std::uint8_t> numbers) {
  if (range.base == 1) {
    for (const std::uint8_t number : numbers) bits.put(number, range.bits);
    return;
  }
  const Packing& packing = range.base == 3 ? kTrits : kQuints;
  for (; !numbers.empty(); numbers = numbers.subspan(std::min(packing.digits, numbers.size()))) {
    const std::span<const std::uint8_t> group = numbers.first(std::min(packing.digits, numbers.size()));
    Digits digits{};
    for (std::size_t i = 0; i < group.size(); ++i) digits[i] = static_cast<std::uint8_t>(group[i] >> range.bits);
    unsigned code = packing.code_of[placeOf(digits, packing.digits, packing.base)];
    for (std::size_t i = 0; i < group.size(); ++i) {
      bits.put(group[i], range.bits);
      bits.put(code, packing.bits[i]);
      code >>= packing.bits[i];
    }
  }
}

}  // namespace mirrorball
