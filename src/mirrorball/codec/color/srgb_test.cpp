#include "mirrorball/codec/color/srgb.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
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

TEST(Dither, EveryCodeStaysInEveryPixel) {
  for (int code = 0; code < 256; ++code) {
    const Image light = linearFromPicture(Image8(32, 32, 3, static_cast<std::uint8_t>(code)));
    const Image8 picture = pictureFromLinear(light, 3, Dither::pattern);
    EXPECT_THAT(picture.samples(), ::testing::Each(code));
  }
}

TEST(Dither, IsTheFormula) {
  Image light(256, 256, 1);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      *light.texel(x, y) = formula::linearFromSrgb1((static_cast<float>(x) + static_cast<float>(y) / 256.0f) / 256.0f);
  const Image8 picture = pictureFromLinear(light, 1, Dither::pattern);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      const float exact = 255.0f * formula::srgbFromLinear1(*light.texel(x, y));
      const float threshold = formula::ditherThreshold(formula::ditherLevel({x, y}));
      const float code = *picture.texel(x, y);
      // 1e-4: what the formula's own float arithmetic leaves open at a code's boundary.
      EXPECT_GE(exact + threshold, code - 1e-4f) << x << " " << y;
      EXPECT_LE(exact + threshold, code + 1.0f + 1e-4f) << x << " " << y;
    }
}

// Of any 16 x 16 pixels, wherever they lie; the nearest codes are off by up to 0.5.
TEST(Dither, TheMeanOfPixelsIsTheLight) {
  for (const float exact : {0.3f, 1.5f, 17.11f, 128.5f, 200.77f, 254.9f}) {
    Image light(80, 48, 1);
    for (float& sample : light.samples()) sample = formula::linearFromSrgb1(exact / 255.0f);
    const Image8 picture = pictureFromLinear(light, 1, Dither::pattern);
    for (int top = 0; top + 16 <= 48; top += 5)
      for (int left = 0; left + 16 <= 80; left += 7) {
        double sum = 0.0;
        for (int y = top; y < top + 16; ++y)
          for (int x = left; x < left + 16; ++x) sum += *picture.texel(x, y);
        EXPECT_NEAR(sum / 256.0, exact, 0.03) << left << " " << top;
      }
  }
}

TEST(Dither, ClipsWhatIsOutsideAndLeavesAlpha) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Image light(64, 1, 4, 0.5f);
  for (int x = 0; x < 64; ++x) {
    light.texel(x, 0)[0] = x % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : -kInfinity;
    light.texel(x, 0)[1] = x % 2 == 0 ? 1.5f : kInfinity;
  }
  const Image8 picture = pictureFromLinear(light, 4, Dither::pattern);
  for (int x = 0; x < 64; ++x) {
    EXPECT_EQ(picture.texel(x, 0)[0], 0);
    EXPECT_EQ(picture.texel(x, 0)[1], 255);
    EXPECT_EQ(picture.texel(x, 0)[3], 128);
  }
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
