#include "mirrorball/image/halve.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "formula/color.h"

namespace mirrorball {
namespace {

TEST(Halved, AConstantStaysForEveryValue) {
  for (int value = 0; value < 256; ++value) {
    const Image8 image(4, 4, 4, static_cast<std::uint8_t>(value));
    for (const bool srgb : {false, true}) {
      const Image8 half = halved(image, srgb);
      for (const std::uint8_t sample : half.samples()) EXPECT_EQ(sample, value) << srgb;
    }
  }
}

TEST(Halved, ColoursAreAveragedAsLightAndTheRestAsNumbers) {
  Image8 board(2, 2, 4);
  for (const int corner : {0, 3}) std::fill_n(board.texel(corner % 2, corner / 2), 4, std::uint8_t{255});
  const Image8 encoded = halved(board, true);
  const Image8 numbers = halved(board, false);
  EXPECT_EQ(encoded.texel(0, 0)[0], std::lround(formula::srgbFromLinear1(0.5f) * 255.0f));
  EXPECT_EQ(encoded.texel(0, 0)[3], 128) << "alpha is never encoded";
  EXPECT_EQ(numbers.texel(0, 0)[0], 128);
}

TEST(Halved, OddAndNarrowSidesRoundDown) {
  const Image8 odd(7, 3, 4, 9);
  EXPECT_EQ(halved(odd, false).width(), 3);
  EXPECT_EQ(halved(odd, false).height(), 1);
  const Image8 line(1, 5, 4, 9);
  EXPECT_EQ(halved(line, true).width(), 1);
  EXPECT_EQ(halved(line, true).height(), 2);
}

TEST(Halved, NumbersAreAveragedAsTheyAre) {
  Image numbers(3, 1, 2);
  const float values[] = {1e5f, -2.0f, 1.0f, 4.0f, 7.0f, 9.0f};
  std::copy_n(values, 6, numbers.texel(0, 0));
  const Image half = halved(numbers);
  ASSERT_EQ(half.width(), 1);
  EXPECT_EQ(half.texel(0, 0)[0], 50000.5f);
  EXPECT_EQ(half.texel(0, 0)[1], 1.0f);
}

}  // namespace
}  // namespace mirrorball
