#include "mirrorball/codec/color/output_primaries.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/image_file_testing.h"

namespace mirrorball {
namespace {

using testing::gradient;

constexpr std::array kWider{OutputPrimaries::p3, OutputPrimaries::rec2020, OutputPrimaries::acescg};

void expectColumns(OutputPrimaries primaries, const glm::mat3& columns) {
  const glm::mat3 matrix = primariesFromRec709(primaries);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) EXPECT_NEAR(matrix[c][r], columns[c][r], 5e-5f) << "column " << c << ", row " << r;
}

TEST(OutputPrimaries, MatricesAreThePublishedOnes) {
  // SMPTE EG 432-1's P3 under D65, as in CSS Color 4, 18: lin_sRGB to lin_P3.
  expectColumns(OutputPrimaries::p3, {0.82246f, 0.03319f, 0.01708f, 0.17754f, 0.96681f, 0.07240f, 0, 0, 0.91052f});
  // ITU-R BT.2087-0, equation 4: M2.
  expectColumns(OutputPrimaries::rec2020,
                {0.6274f, 0.0691f, 0.0164f, 0.3293f, 0.9195f, 0.0880f, 0.0433f, 0.0114f, 0.8956f});
  // OpenColorIO's config of ACES, "Utility - Linear - Rec.709" to "ACES - ACEScg".
  expectColumns(OutputPrimaries::acescg,
                {0.61310f, 0.07019f, 0.02062f, 0.33952f, 0.91635f, 0.10957f, 0.04738f, 0.01345f, 0.86981f});
}

TEST(OutputPrimaries, LightThatIsNotNegativeStaysSoAndWhiteStaysWhite) {
  for (const OutputPrimaries primaries : kWider) {
    const glm::mat3 matrix = primariesFromRec709(primaries);
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) EXPECT_GE(matrix[c][r], 0.0f);
    const glm::vec3 white = matrix * glm::vec3(1.0f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1.0f, 2e-7f);
  }
  EXPECT_EQ(primariesFromRec709(OutputPrimaries::p3)[2].x, 0.0f) << "their blue is the same";
}

TEST(OutputPrimaries, WhatIsConvertedComesBack) {
  for (const OutputPrimaries primaries : kWider) {
    Image image = gradient(7, 5, 4);
    image.texel(3, 2)[1] = 1e5f;
    image.texel(4, 2)[2] = -0.25f;
    Image there = image;
    convertFromRec709(there, primaries);
    EXPECT_GT(std::abs(there.texel(3, 2)[0] - image.texel(3, 2)[0]), 1e4f);
    convertToRec709(there, chromaticitiesOf(primaries));
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 7; ++x)
        for (int c = 0; c < 4; ++c) {
          const float greatest = x == 3 && y == 2 ? 1e5f : 1.0f;
          ASSERT_NEAR(there.texel(x, y)[c], image.texel(x, y)[c], c < 3 ? 1e-6f * greatest : 0.0f) << x << " " << y;
        }
  }
}

TEST(OutputPrimaries, Rec709AndGreyStayBitByBit) {
  Image image = gradient(3, 2, 3);
  convertFromRec709(image, OutputPrimaries::rec709);
  EXPECT_TRUE(std::equal(image.samples().begin(), image.samples().end(), gradient(3, 2, 3).samples().begin()));
  Image grey = gradient(3, 2, 1);
  convertFromRec709(grey, OutputPrimaries::acescg);
  EXPECT_TRUE(std::equal(grey.samples().begin(), grey.samples().end(), gradient(3, 2, 1).samples().begin()));
}

TEST(OutputPrimaries, PureColoursArePureAgain) {
  for (const OutputPrimaries primaries : kWider) {
    Image image(3, 1, 3, 0.0f);
    for (int c = 0; c < 3; ++c) image.texel(c, 0)[c] = c == 0 ? 1e5f : 0.3f;
    convertToRec709(image, chromaticitiesOf(primaries));
    convertFromRec709(image, primaries);
    for (const float sample : image.samples()) EXPECT_GE(sample, 0.0f);
  }
  Image beyond(1, 1, 3, 1.0f);
  beyond.texel(0, 0)[0] = -0.9f;
  convertFromRec709(beyond, OutputPrimaries::p3);
  EXPECT_LT(beyond.texel(0, 0)[0], -0.5f) << "more than rounding stays";
}

TEST(OutputPrimaries, ATexelWithoutANumberHasNoneAfterwards) {
  Image image(2, 1, 4, 0.5f);
  image.texel(0, 0)[1] = std::numeric_limits<float>::quiet_NaN();
  convertFromRec709(image, OutputPrimaries::rec2020);
  for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isnan(image.texel(0, 0)[c]));
  EXPECT_EQ(image.texel(0, 0)[3], 0.5f) << "alpha is no colour";
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.texel(1, 0)[c], 0.5f, 1e-6f) << "its neighbour has nothing of it";
}

}  // namespace
}  // namespace mirrorball
