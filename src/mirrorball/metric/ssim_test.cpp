#include "mirrorball/metric/ssim.h"

#include <cmath>

#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/metric/flip/flip_testing.h"

namespace mirrorball {
namespace {

using testing::flipReference;
using testing::flipTest;

double ssim(const Image& a, const Image& b) { return **structuralSimilarity(a, b); }

/// Equations 14 to 16 and 13 as they stand, window by window.
double ssimByDefinition(const Image& a, const Image& b) {
  const auto luma = [](const Image& image, int x, int y) { return double(formula::luminance(rgbAt(image, x, y))); };
  double all = 0.0;
  int count = 0;
  for (int top = 0; top + 11 <= a.height(); ++top)
    for (int left = 0; left + 11 <= a.width(); ++left) {
      const auto forEach = [&](const auto& visit) {
        for (int y = 0; y < 11; ++y)
          for (int x = 0; x < 11; ++x)
            visit(std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2.0 * 1.5 * 1.5)), luma(a, left + x, top + y),
                  luma(b, left + x, top + y));
      };
      double weights = 0.0, mean_a = 0.0, mean_b = 0.0, variance_a = 0.0, variance_b = 0.0, covariance = 0.0;
      forEach([&](double weight, double, double) { weights += weight; });
      forEach([&](double weight, double sample_a, double sample_b) {
        mean_a += weight / weights * sample_a;
        mean_b += weight / weights * sample_b;
      });
      forEach([&](double weight, double sample_a, double sample_b) {
        variance_a += weight / weights * (sample_a - mean_a) * (sample_a - mean_a);
        variance_b += weight / weights * (sample_b - mean_b) * (sample_b - mean_b);
        covariance += weight / weights * (sample_a - mean_a) * (sample_b - mean_b);
      });
      all += (2 * mean_a * mean_b + 1e-4) * (2 * covariance + 9e-4) /
             ((mean_a * mean_a + mean_b * mean_b + 1e-4) * (variance_a + variance_b + 9e-4));
      ++count;
    }
  return all / count;
}

TEST(Ssim, IsItsDefinition) {
  for (const glm::ivec2 size : {glm::ivec2(61, 47), {11, 11}, {70, 12}, {11, 90}}) {
    const Image a = flipTest(size.x, size.y);
    const Image b = flipReference(size.x, size.y);
    EXPECT_NEAR(ssim(a, b), ssimByDefinition(a, b), 1e-10) << size.x << "x" << size.y;
    EXPECT_LT(ssim(a, b), 0.99);
  }
}

TEST(Ssim, OfEqualPicturesIsOneAndNeverMore) {
  const Image a = flipTest(61, 47);
  const Image b = flipReference(61, 47);
  EXPECT_EQ(ssim(a, a), 1.0);
  EXPECT_EQ(ssim(Image(20, 20, 3), Image(20, 20, 3)), 1.0) << "black";
  EXPECT_DOUBLE_EQ(ssim(a, b), ssim(b, a));
}

TEST(Ssim, OfPlainGreysComparesTheirLuminanceAlone) {
  EXPECT_NEAR(ssim(Image(16, 13, 3, 0.75f), Image(16, 13, 3, 0.25f)),
              (2 * 0.75 * 0.25 + 1e-4) / (0.75 * 0.75 + 0.25 * 0.25 + 1e-4), 1e-12);
}

TEST(Ssim, OfANegativeIsBelowZero) {
  Image picture(40, 40, 1);
  Image negative(40, 40, 1);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      *picture.texel(x, y) = static_cast<float>(testing::noiseAt(x, y, 0)) / 255.0f;
      *negative.texel(x, y) = 1.0f - *picture.texel(x, y);
    }
  EXPECT_LT(ssim(picture, negative), -0.8);
}

TEST(Ssim, IsNothingWhereTheWindowDoesNotFit) {
  EXPECT_FALSE(structuralSimilarity(Image(1, 1, 3), Image(1, 1, 3))->has_value());
  EXPECT_FALSE(structuralSimilarity(Image(10, 90, 3), Image(10, 90, 3))->has_value());
  EXPECT_FALSE(structuralSimilarity(Image(90, 10, 3), Image(90, 10, 3))->has_value());
}

TEST(Ssim, StopsWhenItIsTold) {
  const auto stopped = structuralSimilarity(Image(64, 64, 3), Image(64, 64, 3), [](auto, auto) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
