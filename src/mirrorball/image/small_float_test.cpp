#include "mirrorball/image/small_float.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/base/bit_cast.h"

namespace mirrorball {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// The definition, by arithmetic alone: 5 exponent bits with bias 15, no sign.
template <int kMantissaBits>
float valueOf(unsigned bits) {
  const int exponent = static_cast<int>(bits >> kMantissaBits);
  const int mantissa = static_cast<int>(bits & ((1u << kMantissaBits) - 1u));
  if (exponent == 31) return mantissa == 0 ? kInfinity : kNan;
  const int leading = exponent == 0 ? 0 : 1 << kMantissaBits;
  return std::ldexp(static_cast<float>(leading + mantissa), std::max(exponent, 1) - 15 - kMantissaBits);
}

/// Every value, every middle between two neighbours, and the floats beside each middle.
template <int kMantissaBits>
void checkEveryValueAndMiddle() {
  constexpr unsigned kInfinityBits = 31u << kMantissaBits;
  for (unsigned bits = 0; bits < kInfinityBits; ++bits) {
    const float below = valueOf<kMantissaBits>(bits);
    // What would follow the largest finite value is 65536: its middle rounds to infinity, which is even.
    const float above = bits + 1 == kInfinityBits ? 65536.0f : valueOf<kMantissaBits>(bits + 1);
    const float middle = (below + above) / 2.0f;  // exact: a float has more bits
    ASSERT_EQ(smallFloatBits<kMantissaBits>(below), bits);
    ASSERT_EQ(smallFloatBits<kMantissaBits>(std::nextafter(middle, 0.0f)), bits);
    ASSERT_EQ(smallFloatBits<kMantissaBits>(middle), bits % 2 == 0 ? bits : bits + 1);
    ASSERT_EQ(smallFloatBits<kMantissaBits>(std::nextafter(middle, 1e6f)), bits + 1);
  }
  EXPECT_EQ(valueOf<kMantissaBits>(kInfinityBits - 1), kLargestSmallFloat<kMantissaBits>);
  EXPECT_EQ(smallFloatBits<kMantissaBits>(kInfinity), kInfinityBits);
  EXPECT_GT(smallFloatBits<kMantissaBits>(kNan), kInfinityBits);
  EXPECT_EQ(smallFloatBits<kMantissaBits>(std::numeric_limits<float>::denorm_min()), 0u);
}

TEST(SmallFloat, HalfIsCorrectlyRounded) { checkEveryValueAndMiddle<10>(); }
TEST(SmallFloat, ElevenBitsAreCorrectlyRounded) { checkEveryValueAndMiddle<6>(); }
TEST(SmallFloat, TenBitsAreCorrectlyRounded) { checkEveryValueAndMiddle<5>(); }

TEST(SmallFloat, EveryHalfHasItsValue) {
  for (unsigned bits = 0; bits <= 0xffffu; ++bits) {
    const float value = floatFromHalf(static_cast<std::uint16_t>(bits));
    const float size = valueOf<10>(bits & 0x7fffu);
    if (std::isnan(size)) {
      ASSERT_TRUE(std::isnan(value)) << bits;
      continue;
    }
    ASSERT_EQ(value, bits & 0x8000u ? -size : size) << bits;
    ASSERT_EQ(std::signbit(value), (bits & 0x8000u) != 0) << bits;
    ASSERT_EQ(halfFromFloat(value), bits);
  }
}

/// The instruction and the portable way agree on every bit, for floats all over the range.
TEST(SmallFloat, RowsAreWhatSinglesAre) {
  std::vector<float> floats;
  for (std::uint64_t bits = 0; bits <= 0xffffffffu; bits += 9973)
    floats.push_back(bitCast<float>(static_cast<std::uint32_t>(bits)));
  while (floats.size() % 24 != 21) floats.pop_back();  // an odd number of texels, with a rest behind every step
  std::vector<std::uint16_t> halves(floats.size());
  EXPECT_FALSE(halvesFromFloats(floats, halves));
  std::vector<std::uint16_t> rgba(floats.size() / 3 * 4);
  EXPECT_FALSE(rgbaHalvesFromRgb(floats, rgba));
  const auto same = [](std::uint16_t a, std::uint16_t b) {
    const bool both_nan = (a & 0x7fffu) > 0x7c00u && (b & 0x7fffu) > 0x7c00u;  // what a NaN carries may differ
    return a == b || both_nan;
  };
  for (std::size_t i = 0; i < floats.size(); ++i) {
    ASSERT_TRUE(same(halves[i], halfFromFloat(floats[i]))) << floats[i];
    ASSERT_TRUE(same(rgba[i / 3 * 4 + i % 3], halves[i])) << floats[i];
    ASSERT_EQ(rgba[i / 3 * 4 + 3], 0x3c00) << "alpha is 1";
  }
  std::vector<float> back(halves.size());
  floatsFromHalves(halves, back);
  for (std::size_t i = 0; i < halves.size(); ++i)
    ASSERT_TRUE(std::isnan(back[i]) || back[i] == floatFromHalf(halves[i])) << halves[i];
}

TEST(SmallFloat, WhatDoesNotFitIsToldWhereverItStands) {
  for (std::size_t place = 0; place < 21; ++place)
    for (const float value : {65504.0f, 65505.0f, -65504.0f, -65505.0f, 1e30f, kInfinity, -kInfinity, kNan}) {
      std::vector<float> floats(21, 1.0f);
      floats[place] = value;
      std::vector<std::uint16_t> halves(21);
      std::vector<std::uint16_t> rgba(28);
      const bool fits = !std::isfinite(value) || std::abs(value) <= 65504.0f;
      EXPECT_EQ(halvesFromFloats(floats, halves), fits) << value << " at " << place;
      EXPECT_EQ(rgbaHalvesFromRgb(floats, rgba), fits) << value << " at " << place;
    }
}

}  // namespace
}  // namespace mirrorball
