#include "mirrorball/codec/color/srgb.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "formula/color.h"

namespace mirrorball {
namespace {

TEST(Srgb, EveryCodeComesBack) {
  Image8 codes(256, 1, 1);
  for (int code = 0; code < 256; ++code) codes.texel(code, 0)[0] = static_cast<std::uint8_t>(code);
  const Image light = linearFromPicture(codes);
  EXPECT_EQ(light.samples().front(), 0.0f);
  EXPECT_EQ(light.samples().back(), 1.0f);
  for (int code = 0; code < 256; ++code) EXPECT_EQ(srgb8FromLinear(light.texel(code, 0)[0]), code);
}

TEST(Srgb, EncodingRoundsTheFormula) {
  // 1e-4: what the formula's own float arithmetic leaves open at a code's boundary.
  for (int i = 0; i <= 1'000'000; ++i) {
    const float light = static_cast<float>(i) * 1e-6f;
    const float exact = 255.0f * formula::srgbFromLinear1(light);
    ASSERT_LE(std::abs(static_cast<float>(srgb8FromLinear(light)) - exact), 0.5f + 1e-4f) << light;
  }
}

TEST(Srgb, WhatIsOutsideIsClipped) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(srgb8FromLinear(-0.5f), 0);
  EXPECT_EQ(srgb8FromLinear(-kInfinity), 0);
  EXPECT_EQ(srgb8FromLinear(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(srgb8FromLinear(std::numeric_limits<float>::denorm_min()), 0);
  EXPECT_EQ(srgb8FromLinear(1.5f), 255);
  EXPECT_EQ(srgb8FromLinear(kInfinity), 255);
}

TEST(Srgb, AlphaIsNotEncoded) {
  Image8 picture(1, 1, 4, 128);
  const Image light = linearFromPicture(picture);
  EXPECT_FLOAT_EQ(light.samples()[3], 128.0f / 255.0f);
  EXPECT_LT(light.samples()[0], 0.22f);
  EXPECT_EQ(pictureFromLinear(light, 4).samples()[3], 128);
}

TEST(Srgb, SixteenBitsKeepTheirPrecision) {
  const std::uint16_t samples[] = {0, 1, 1000, 1001, 65535};
  const Image light = linearFromSamples16(samples, 5, 1, 1);
  for (int i = 0; i < 5; ++i)
    EXPECT_FLOAT_EQ(light.texel(i, 0)[0], formula::linearFromSrgb1(static_cast<float>(samples[i]) / 65535.0f));
  EXPECT_LT(light.texel(2, 0)[0], light.texel(3, 0)[0]);
}

}  // namespace
}  // namespace mirrorball
