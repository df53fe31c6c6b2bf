#include "mirrorball/image/image.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/image/filter.h"

namespace mirrorball {
namespace {

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

/// 4 × 3 texels of one channel, value x + 10 y.
Image ramp() {
  Image image(4, 3, 1);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) *image.texel(x, y) = static_cast<float>(x + 10 * y);
  return image;
}

TEST(Image, RowsRunFromTheTopWithoutPadding) {
  const Image image = ramp();
  EXPECT_EQ(image.samples()[5], 11.0f);
  EXPECT_EQ(image.row(2)[3], 23.0f);
  EXPECT_EQ(rgbAt(image, 1, 2), glm::vec3(21.0f));
  EXPECT_EQ(rgbaAt(image, 1, 2).w, 1.0f);
}

TEST(Image, LightAloneHasThreeChannels) {
  Image grey(2, 1, 1, 0.5f);
  Image covered(2, 1, 4, 0.25f);
  covered.texel(1, 0)[3] = 0.0f;
  EXPECT_EQ(rgbOf(grey).channels(), 3);
  EXPECT_EQ(rgbAt(rgbOf(grey), 1, 0), glm::vec3(0.5f));
  EXPECT_EQ(rgbOf(covered).channels(), 3);
  EXPECT_EQ(rgbAt(rgbOf(covered), 1, 0), glm::vec3(0.25f));
}

TEST(Image, LargestSampleIsOfAllChannelsAndNoNaN) {
  Image image(2, 1, 3, -1.0f);
  EXPECT_EQ(largestSample(image), 0.0f);
  image.texel(0, 0)[2] = 7.0f;
  image.texel(1, 0)[0] = kNotANumber;
  EXPECT_EQ(largestSample(image), 7.0f);
  image.texel(1, 0)[1] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(largestSample(image), std::numeric_limits<float>::infinity());
}

TEST(NonFinite, IsCountedByTexelWithTheFirstNamed) {
  Image image(3, 2, 3, 1.0f);
  EXPECT_EQ(findNonFinite(image).count, 0u);
  image.texel(2, 0)[1] = kNotANumber;
  image.texel(2, 0)[2] = kNotANumber;
  image.texel(0, 1)[0] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(findNonFinite(image).count, 2u);
  EXPECT_EQ(findNonFinite(image).first, glm::ivec2(2, 0));
}

TEST(NonFinite, RepairTakesTheMeanOfTheNeighboursRingByRing) {
  Image image(5, 5, 1, 2.0f);
  for (int y = 1; y < 4; ++y)
    for (int x = 1; x < 4; ++x) *image.texel(x, y) = kNotANumber;
  ASSERT_TRUE(repairNonFinite(image));
  for (const float sample : image.samples()) EXPECT_EQ(sample, 2.0f);

  Image edge = ramp();
  *edge.texel(0, 0) = kNotANumber;
  ASSERT_TRUE(repairNonFinite(edge));
  EXPECT_FLOAT_EQ(*edge.texel(0, 0), (1.0f + 10.0f + 11.0f) / 3.0f);

  Image hopeless(2, 2, 1, kNotANumber);
  EXPECT_EQ(repairNonFinite(hopeless).error().code, ErrorCode::non_finite);
}

TEST(CheckDimensions, RefusesNothingAndTooMuch) {
  EXPECT_TRUE(checkDimensions(32768, 32768));
  EXPECT_EQ(checkDimensions(0, 5).error().code, ErrorCode::bad_file);
  EXPECT_EQ(checkDimensions(5, -1).error().code, ErrorCode::bad_file);
  EXPECT_EQ(checkDimensions(1LL << 31, 1).error().code, ErrorCode::too_large);
  EXPECT_EQ(checkDimensions(1LL << 62, 1LL << 62).error().code, ErrorCode::too_large);
}

TEST(Bilinear, IsExactOnARamp) {
  const Image image = ramp();
  const auto fetch = [&](int x, int y) { return rgbaAt(image, x, y); };
  EXPECT_FLOAT_EQ(bilinear({1.5f, 1.5f}, fetch).x, 11.0f) << "at a texel's centre";
  EXPECT_FLOAT_EQ(bilinear({2.25f, 1.75f}, fetch).x, 1.75f + 12.5f);
}

TEST(Bilinear, WeightZeroIsLeftOut) {
  const auto fetch = [](int x, int) { return x < 1 ? glm::vec4(8, 8, 8, 1) : glm::vec4(0); };
  EXPECT_FLOAT_EQ(bilinear({1.2f, 0.5f}, fetch).x, 8.0f);
  EXPECT_EQ(bilinear({3.0f, 0.5f}, fetch), glm::vec4(0));
}

}  // namespace
}  // namespace mirrorball
