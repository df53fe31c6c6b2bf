#include "mirrorball/codec/uastc_hdr/uastc_hdr_levels.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "mirrorball/codec/uastc_hdr/uastc_hdr_modes.h"

namespace mirrorball {
namespace {

/// Spreads a number with a digit of base 3 or 5: the digit counts `step`, the bits above the last one are repeated as
/// `repeated`, and the last one turns all over.
constexpr int spread(int digit, int step, int repeated, bool is_turned, int width) {
  const int sum = digit * step + repeated;
  const int turned = is_turned ? sum ^ ((1 << (width + 1)) - 1) : sum;
  return (is_turned ? 1 << (width - 1) : 0) | turned >> 2;
}

/// The bits repeated from the top down to `width` bits.
constexpr int repeatedBits(int number, int bits, int width) {
  int value = 0;
  for (int at = width - bits; at > -bits; at -= bits) value |= at >= 0 ? number << at : number >> -at;
  return value;
}

constexpr int weightOf(IntegerRange range, int number) {
  const int digit = number >> range.bits;
  const int upper = number >> 1 & 1;  // of two bits at most
  int value = 0;
  if (range.base == 1)
    value = repeatedBits(number, range.bits, 6);
  else if (range.bits == 0)
    value = range.base == 3 ? (63 * digit + 1) / 2 : (63 * digit + 2) / 4;
  else if (range.base == 5)
    value = spread(digit, 28, 0, number & 1, 6);
  else
    value = range.bits == 1 ? spread(digit, 50, 0, number & 1, 6) : spread(digit, 23, upper * 0x45, number & 1, 6);
  return value > 32 ? value + 1 : value;
}

constexpr int endpointOf(IntegerRange range, int number) {
  const int digit = number >> range.bits;
  const int upper = (number & ((1 << range.bits) - 1)) >> 1;  // all bits but the last
  if (range.base == 1) return repeatedBits(number, range.bits, 8);
  if (range.levels() == 192) return spread(digit, 5, upper << 4 | upper >> 4, number & 1, 8);
  if (range.levels() == 80) return spread(digit, 13, upper << 6 | upper >> 1, number & 1, 8);
  return spread(digit, 26, upper << 7 | upper << 1 | upper >> 1, number & 1, 8);  // 40
}

constexpr WeightLevels makeWeightLevels(int count) {
  WeightLevels levels{.count = count};
  for (int number = 0; number < count; ++number) {
    const auto share = static_cast<std::uint8_t>(weightOf(integerRange(count), number));
    std::size_t at = static_cast<std::size_t>(number);
    for (; at > 0 && levels.shares[at - 1] > share; --at) {
      levels.shares[at] = levels.shares[at - 1];
      levels.numbers[at] = levels.numbers[at - 1];
    }
    levels.shares[at] = share;
    levels.numbers[at] = static_cast<std::uint8_t>(number);
  }
  return levels;
}

constexpr EndpointLevels makeEndpointLevels(int count) {
  EndpointLevels levels;
  std::array<bool, 256> is_level{};
  for (int number = 0; number < count; ++number) {
    const auto value = static_cast<std::uint8_t>(endpointOf(integerRange(count), number));
    levels.values[static_cast<std::size_t>(number)] = value;
    levels.numbers[value] = static_cast<std::uint8_t>(number);
    is_level[value] = true;
  }
  for (int byte = 0; byte < 256; ++byte) {
    // Every 32 values have a level, so this ends.
    const auto isNear = [&](int value) { return value >> 5 == byte >> 5 && is_level[static_cast<std::size_t>(value)]; };
    int off = 0;
    while (!isNear(byte - off) && !isNear(byte + off)) ++off;
    levels.nearest[static_cast<std::size_t>(byte)] =
        static_cast<std::uint8_t>(isNear(byte - off) ? byte - off : byte + off);
  }
  return levels;
}

constexpr std::array<int, 8> kCountsOfLevels{3, 4, 5, 6, 8, 10, 12, 16};
constexpr std::array<WeightLevels, 8> kWeightLevels = [] {
  std::array<WeightLevels, 8> all;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = makeWeightLevels(kCountsOfLevels[i]);
  return all;
}();

constexpr std::array<int, 6> kEndpointCounts{40, 64, 80, 128, 192, 256};
constexpr std::array<EndpointLevels, 6> kEndpointLevels = [] {
  std::array<EndpointLevels, 6> all;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = makeEndpointLevels(kEndpointCounts[i]);
  return all;
}();

}  // namespace

const WeightLevels& weightLevels(int count) {
  const auto found = std::find(kCountsOfLevels.begin(), kCountsOfLevels.end(), count);
  assert(found != kCountsOfLevels.end());
  return kWeightLevels[std::size_t(found - kCountsOfLevels.begin())];
}

const EndpointLevels& endpointLevels(int count) {
  const auto found = std::find(kEndpointCounts.begin(), kEndpointCounts.end(), count);
  assert(found != kEndpointCounts.end());
  return kEndpointLevels[std::size_t(found - kEndpointCounts.begin())];
}

}  // namespace mirrorball
