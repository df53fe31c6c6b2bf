#include "mirrorball/metric/comparison.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/metric/flip/flip_testing.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

Comparison compared(const Image& test, const Image& reference, ImageKind kind,
                    const ComparisonSettings& settings = {}) {
  return *compareImages(*comparedImage(test, kind), *comparedImage(reference, kind), kind, settings);
}

double valueOf(const Comparison& comparison, Metric metric) { return *comparison.value(metric); }

TEST(CompareImages, PicturesAreComparedByTheirCodesAndRelativelyByTheirLight) {
  const Image test(20, 15, 3, formula::linearFromSrgb1(0.6f));
  const Image reference(20, 15, 3, formula::linearFromSrgb1(0.5f));
  const Comparison comparison = compared(test, reference, ImageKind::picture);
  EXPECT_NEAR(valueOf(comparison, Metric::rmse), 0.1, 1e-6);
  EXPECT_NEAR(valueOf(comparison, Metric::psnr), 20.0, 1e-4);
  EXPECT_NEAR(valueOf(comparison, Metric::ssim), (2 * 0.6 * 0.5 + 1e-4) / (0.36 + 0.25 + 1e-4), 1e-6);
  const auto dark = double(formula::linearFromSrgb1(0.5f));
  const double difference = double(formula::linearFromSrgb1(0.6f)) - dark;
  EXPECT_NEAR(valueOf(comparison, Metric::relmse), difference * difference / (dark * dark + 0.01), 1e-6);
  EXPECT_FALSE(comparison.value(Metric::alpha));
  EXPECT_NEAR(comparison.test_at_worst.x, 0.6f, 1e-6f);
  EXPECT_NEAR(*comparison.difference.texel(7, 7), 0.1f, 1e-6f);
}

TEST(CompareImages, LightIsComparedAsItIsAndAsTheToneMapShowsIt) {
  const Image test(20, 15, 3, 1e5f);
  Image reference = test;
  reference.texel(12, 3)[2] = 1e5f - 1024.0f;
  const Comparison comparison = compared(test, reference, ImageKind::light);
  EXPECT_NEAR(valueOf(comparison, Metric::rmse), 1024.0 / std::sqrt(20.0 * 15.0 * 3.0), 1e-9);
  EXPECT_EQ(comparison.worst, glm::ivec2(12, 3));
  EXPECT_EQ(comparison.test_at_worst, glm::vec3(1e5f));
  EXPECT_EQ(*comparison.difference.texel(12, 3), 1024.0f);
  EXPECT_GT(valueOf(comparison, Metric::psnr), 80.0) << "both are white on a display";

  // With the linear curve and a factor of 1/2, 0.8 against 0.4 are the codes of 0.4 and 0.2.
  const ComparisonSettings half{.exposure = 0.5f, .tone_map = 4};
  const Comparison dim = compared(Image(20, 15, 3, 0.8f), Image(20, 15, 3, 0.4f), ImageKind::light, half);
  const auto codes = double(formula::srgbFromLinear1(0.4f)) - double(formula::srgbFromLinear1(0.2f));
  EXPECT_NEAR(valueOf(dim, Metric::psnr), -20.0 * std::log10(codes), 1e-4);
  EXPECT_NEAR(valueOf(dim, Metric::rmse), 0.4, 1e-6) << "radiance is not exposed";
}

TEST(CompareImages, EqualImagesAreEqualByEveryMetric) {
  const Image picture = testing::flipReference(37, 23);
  for (const auto& [image, kind] :
       {std::pair(picture, ImageKind::picture), {testing::asLight(picture), ImageKind::light}}) {
    const Comparison comparison = compared(image, image, kind);
    EXPECT_EQ(valueOf(comparison, Metric::rmse), 0.0);
    EXPECT_EQ(valueOf(comparison, Metric::relmse), 0.0);
    EXPECT_EQ(valueOf(comparison, Metric::psnr), std::numeric_limits<double>::infinity());
    EXPECT_EQ(valueOf(comparison, Metric::ssim), 1.0);
    EXPECT_EQ(valueOf(comparison, Metric::flip), 0.0);
  }
}

TEST(CompareImages, OnePixelAndOneRowHaveAllButSsim) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 100}, {100, 1}})
    for (const ImageKind kind : {ImageKind::picture, ImageKind::light}) {
      const Comparison comparison = compared(Image(size.x, size.y, 1, 0.5f), Image(size.x, size.y, 3, 0.25f), kind);
      EXPECT_FALSE(comparison.value(Metric::ssim));
      EXPECT_GT(valueOf(comparison, Metric::flip), 0.1);
      EXPECT_LT(valueOf(comparison, Metric::flip), 1.0);
    }
}

TEST(CompareImages, FlipIsThatOfItsKind) {
  const Image test = testing::flipTest(61, 47);
  const Image reference = testing::flipReference(61, 47);
  EXPECT_NEAR(valueOf(compared(test, reference, ImageKind::picture), Metric::flip), 0.271595497, 1e-7);
  EXPECT_NEAR(valueOf(compared(test, reference, ImageKind::picture, {.pixels_per_degree = 20.0f}), Metric::flip),
              0.403052024, 1e-7);
  const Comparison light = compared(testing::asLight(test), testing::asLight(reference), ImageKind::light);
  EXPECT_NEAR(valueOf(light, Metric::flip), 0.261788172, 1e-7);
  EXPECT_EQ(light.exposures.count, 17);
  EXPECT_EQ(light.worst_flip, glm::ivec2(58, 0)) << "as the published program has it";
  EXPECT_NEAR(light.max_flip, 0.987069547f, 2e-6f);
}

TEST(CompareImages, ColoursCountByTheirCoverageWhichIsAMetricItself) {
  Image test(16, 16, 4, 1.0f);
  Image reference(16, 16, 4, 1.0f);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 8; ++x) {
      test.texel(x, y)[3] = 0.0f;
      reference.texel(x, y)[3] = 0.0f;
      reference.texel(x, y)[0] = 0.0f;
    }
  const Comparison unseen = compared(test, reference, ImageKind::picture);
  EXPECT_EQ(valueOf(unseen, Metric::rmse), 0.0) << "what is transparent has no colour";
  EXPECT_EQ(valueOf(unseen, Metric::alpha), 0.0);
  const Comparison against_opaque = compared(test, Image(16, 16, 3, 1.0f), ImageKind::picture);
  EXPECT_NEAR(valueOf(against_opaque, Metric::alpha), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(valueOf(against_opaque, Metric::rmse), std::sqrt(0.5), 1e-6);
  // Light is premultiplied already: what is transparent may shine.
  EXPECT_NEAR(valueOf(compared(test, reference, ImageKind::light), Metric::rmse), std::sqrt(0.5 / 3.0), 1e-12);
  EXPECT_FALSE(compared(Image(16, 16, 4, 1.0f), Image(16, 16, 3, 1.0f), ImageKind::picture).value(Metric::alpha))
      << "opaque everywhere";
}

TEST(CompareImages, SizesThatDifferAndWhatIsNotFiniteAreRefused) {
  const auto sizes = compareImages({Image(4, 3, 3), {}}, {Image(3, 4, 3), {}}, ImageKind::picture);
  ASSERT_FALSE(sizes);
  EXPECT_EQ(sizes.error().code, ErrorCode::bad_shape);
  EXPECT_THAT(sizes.error().message, HasSubstr("4x3 and 3x4"));
  Image bad(4, 3, 3);
  bad.texel(2, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  bad.texel(3, 2)[1] = std::numeric_limits<float>::infinity();
  const auto refused = comparedImage(bad, ImageKind::light);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::non_finite);
  EXPECT_THAT(refused.error().message, HasSubstr("2 texels are NaN or infinite, the first at (2, 1)"));
  EXPECT_EQ(refused.error().fix_hint, FixHint::repair);
}

TEST(CompareImages, NegativeLightIsADifferenceOfRadianceThatNoDisplayShows) {
  const Comparison comparison = compared(Image(16, 16, 3, -0.5f), Image(16, 16, 3), ImageKind::light);
  EXPECT_EQ(valueOf(comparison, Metric::rmse), 0.5);
  EXPECT_EQ(valueOf(comparison, Metric::psnr), std::numeric_limits<double>::infinity());
  EXPECT_EQ(valueOf(comparison, Metric::flip), 0.0);
}

TEST(CompareImages, TellsHowFarItIsAndStops) {
  std::size_t last = 0;
  const Image image = testing::flipReference(64, 300);
  const ComparedImage side{image, {}};
  EXPECT_TRUE(compareImages(side, side, ImageKind::picture, {}, [&](std::size_t done, std::size_t total) {
    EXPECT_LE(done, total);
    last = std::max(last, 100 * done / total);
    return true;
  }));
  EXPECT_EQ(last, 100u);
  const auto stopped = compareImages(side, side, ImageKind::picture, {}, [](auto, auto) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

TEST(Metrics, KnowWhichWayIsWorseAndHowTheyAreWritten) {
  EXPECT_TRUE(isWorse(Metric::psnr, 30.0, 40.0));
  EXPECT_FALSE(isWorse(Metric::psnr, std::numeric_limits<double>::infinity(), 40.0));
  EXPECT_TRUE(isWorse(Metric::ssim, 0.9, 0.95));
  EXPECT_TRUE(isWorse(Metric::flip, 0.2, 0.1));
  EXPECT_FALSE(isWorse(Metric::rmse, 0.1, 0.1)) << "as good is not worse";
  EXPECT_EQ(valueText(Metric::psnr, 31.416), "31.42 dB");
  EXPECT_EQ(valueText(Metric::psnr, std::numeric_limits<double>::infinity()), "infinite");
  EXPECT_EQ(valueText(Metric::flip, 0.0123456), "0.012346");
}

}  // namespace
}  // namespace mirrorball
