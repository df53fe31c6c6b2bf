#include "mirrorball/codec/uastc_hdr/uastc_hdr_colors.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using FloatEnds = std::array<std::array<float, 3>, 2>;
using ::testing::ElementsAre;

/// Ends around a random colour, at most `spread` from it.
FloatEnds randomEnds(float spread, std::mt19937& random) {
  std::uniform_real_distribution<float> color(0.0f, static_cast<float>(kLargestColor));
  std::uniform_real_distribution<float> off(-spread, spread);
  const float around = color(random);
  FloatEnds ends;
  for (auto& end : ends)
    for (float& channel : end) channel = std::clamp(around + off(random), 0.0f, static_cast<float>(kLargestColor));
  return ends;
}

/// The greatest difference between ends, in the better of their orders.
float farthest(const ColorEnds& found, const FloatEnds& expected) {
  const auto with = [&](std::size_t turned) {
    float most = 0.0f;
    for (std::size_t e = 0; e < 2; ++e)
      for (std::size_t c = 0; c < 3; ++c)
        most = std::max(most, std::abs(static_cast<float>(found[e ^ turned][c]) - expected[e][c]));
    return most;
  };
  return std::min(with(0), with(1));
}

TEST(UastcHdrLevels, AreTheSpecifications) {
  const auto shares = [](int count) {
    const auto& all = weightLevels(count).shares;
    return std::vector<int>(all.begin(), all.begin() + count);
  };
  EXPECT_THAT(shares(3), ElementsAre(0, 32, 64));
  EXPECT_THAT(shares(4), ElementsAre(0, 21, 43, 64));
  EXPECT_THAT(shares(5), ElementsAre(0, 16, 32, 48, 64));
  EXPECT_THAT(shares(6), ElementsAre(0, 12, 25, 39, 52, 64));
  EXPECT_THAT(shares(8), ElementsAre(0, 9, 18, 27, 37, 46, 55, 64));
  EXPECT_THAT(shares(10), ElementsAre(0, 7, 14, 21, 28, 36, 43, 50, 57, 64));
  EXPECT_THAT(shares(12), ElementsAre(0, 5, 11, 17, 23, 28, 36, 41, 47, 53, 59, 64));
  EXPECT_THAT(shares(16), ElementsAre(0, 4, 8, 12, 17, 21, 25, 29, 35, 39, 43, 47, 52, 56, 60, 64));
  for (const int count : {40, 64, 80, 128, 192, 256}) {
    const EndpointLevels& levels = endpointLevels(count);
    std::vector<int> values(levels.values.begin(), levels.values.begin() + count);
    std::sort(values.begin(), values.end());
    EXPECT_EQ(std::unique(values.begin(), values.end()), values.end()) << count;
    EXPECT_EQ(values.front(), 0) << count;
    EXPECT_EQ(values.back(), 255) << count;
    for (std::size_t byte = 0; byte < 256; ++byte) EXPECT_EQ(levels.nearest[byte] >> 5, byte >> 5) << count;
  }
}

/// What is packed stands for what is said of it, near to what was wished: ends close together as near as 12 bits have
/// it, and no ends farther than the coarsest of all ways.
TEST(UastcHdrColors, ArePackedNearWhatIsWished) {
  std::mt19937 random(17);
  for (const ColorMode mode : {ColorMode::two_colors, ColorMode::base_and_offset})
    for (const int count : {40, 64, 80, 128, 192, 256})
      for (const float spread : {0.0f, 8.0f, 100.0f, 4000.0f})
        for (int round = 0; round < 500; ++round) {
          FloatEnds ends = randomEnds(spread, random);
          // An offset that is the same in all channels is all that this mode has.
          if (mode == ColorMode::base_and_offset) {
            const float least = *std::min_element(ends[1].begin(), ends[1].end());
            for (std::size_t c = 0; c < 3; ++c) ends[0][c] = ends[1][c] - std::min(least, spread);
          }
          const PackedColors packed = packColors(mode, ends, endpointLevels(count));
          ASSERT_EQ(packed.ends, unpackColors(mode, packed.bytes));
          ASSERT_TRUE(areFinite(packed.ends));
          for (int i = 0; i < numbersOf(mode); ++i) {
            const std::uint8_t byte = packed.bytes[std::size_t(i)];
            ASSERT_EQ(endpointLevels(count).nearest[byte], byte) << "is one of the levels";
          }
          const float coarsest = count == 256 ? 48.0f : count >= 128 ? 112.0f : 260.0f;
          ASSERT_LE(farthest(packed.ends, ends), spread <= 8.0f && count == 256 ? 2.0f : coarsest)
              << count << " levels, " << spread;
        }
}

TEST(UastcHdrColors, WhatIsNoFiniteLightIsPackedAsTheBrightest) {
  for (const ColorMode mode : {ColorMode::two_colors, ColorMode::base_and_offset})
    for (const int count : {40, 80, 192, 256}) {
      FloatEnds ends;
      ends[0].fill(1e9f);
      ends[1].fill(1e9f);
      const PackedColors packed = packColors(mode, ends, endpointLevels(count));
      EXPECT_TRUE(areFinite(packed.ends));
      EXPECT_GE(packed.ends[1][1], kLargestColor - 96) << count;
    }
}

}  // namespace
}  // namespace mirrorball
