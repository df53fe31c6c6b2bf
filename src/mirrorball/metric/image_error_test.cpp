#include "mirrorball/metric/image_error.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mirrorball/metric/flip/flip_testing.h"

namespace mirrorball {
namespace {

/// A picture and the same with every sample raised, of numbers that floats hold exactly.
struct Offset {
  Image reference;
  Image raised;

  Offset(int width, int height, int channels, float level, float offset)
      : reference(width, height, channels, level), raised(width, height, channels, level + offset) {}
};

TEST(ImageError, OfAConstantOffsetIsTheOffset) {
  for (const int channels : {1, 3, 4}) {
    const Offset pair(37, 5, channels, 0.5f, 0.125f);
    const ImageError error = imageError(pair.raised, pair.reference);
    EXPECT_EQ(error.mean_square, 0.015625);
    EXPECT_EQ(error.mean_of_worst, 0.125);
    EXPECT_EQ(error.max, 0.125f);
    EXPECT_EQ(error.worst, glm::ivec2(0, 0));
    EXPECT_NEAR(error.relative_mean_square, 0.015625 / (0.25 + 0.01), 1e-15);
    EXPECT_EQ(imageError(pair.reference, pair.raised).mean_square, 0.015625) << "squares have no sign";
  }
}

TEST(ImageError, IsRelativeToTheReferenceAndNotToTheTest) {
  const Offset pair(2, 2, 3, 1.0f, 1.0f);
  EXPECT_NEAR(imageError(pair.raised, pair.reference).relative_mean_square, 1.0 / 1.01, 1e-15);
  EXPECT_NEAR(imageError(pair.reference, pair.raised).relative_mean_square, 1.0 / 4.01, 1e-15);
  const Offset on_black(2, 2, 3, 0.0f, 0.5f);
  EXPECT_NEAR(imageError(on_black.raised, on_black.reference).relative_mean_square, 25.0, 1e-12);
}

TEST(ImageError, OneSampleCountsAsOne) {
  Image reference(61, 47, 3, 0.25f);
  Image test = reference;
  test.texel(50, 33)[1] = -0.75f;
  const ImageError error = imageError(test, reference);
  EXPECT_EQ(error.worst, glm::ivec2(50, 33));
  EXPECT_EQ(error.max, 1.0f);
  EXPECT_DOUBLE_EQ(error.mean_square, 1.0 / (61 * 47 * 3));
  EXPECT_DOUBLE_EQ(error.mean_of_worst, 1.0 / (61 * 47)) << "of a pixel only the worst channel counts";
}

TEST(ImageError, OfEqualImagesIsNothing) {
  const Image image = testing::asLight(testing::flipReference(61, 47));
  const ImageError error = imageError(image, image);
  EXPECT_EQ(error.mean_square, 0.0);
  EXPECT_EQ(error.relative_mean_square, 0.0);
  EXPECT_EQ(error.max, 0.0f);
}

TEST(ImageError, LightOf1e5IsSummedWithoutLoss) {
  const Offset pair(1000, 100, 3, 100000.0f, 0.5f);
  EXPECT_EQ(imageError(pair.raised, pair.reference).mean_square, 0.25);
  const Offset single(1, 1, 1, 1e30f, 1e30f);
  EXPECT_TRUE(std::isfinite(imageError(single.raised, single.reference).mean_square)) << "whose square is no float";
}

TEST(PeakSignalToNoise, IsThatOfTheNoise) {
  EXPECT_NEAR(peakSignalToNoise_db(0.01), 20.0, 1e-12);
  EXPECT_NEAR(peakSignalToNoise_db(1.0 / (255.0 * 255.0)), 48.1308, 1e-4) << "one code of 8 bits";
  EXPECT_EQ(peakSignalToNoise_db(0.0), std::numeric_limits<double>::infinity());
  // Noise that is even from −1/8 to 1/8 has a mean square of 1/8² / 3.
  const Image reference(200, 200, 3, 0.5f);
  Image noisy = reference;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      for (int channel = 0; channel < 3; ++channel)
        noisy.texel(x, y)[channel] += (static_cast<float>(testing::noiseAt(x, y, channel)) - 127.5f) / 1024.0f;
  EXPECT_NEAR(peakSignalToNoise_db(imageError(noisy, reference).mean_square), 20.0 * std::log10(8.0 * std::sqrt(3.0)),
              0.05);
}

TEST(SignedDifference, HasTheSignOfTheChannelThatIsFarthestApart) {
  Image reference(3, 2, 3, 0.5f);
  Image test = reference;
  test.texel(0, 0)[0] = 0.75f;
  test.texel(2, 1)[1] = 0.75f;
  test.texel(2, 1)[2] = 0.125f;
  const Image difference = signedDifference(test, reference);
  EXPECT_EQ(*difference.texel(0, 0), 0.25f);
  EXPECT_EQ(*difference.texel(1, 0), 0.0f);
  EXPECT_EQ(*difference.texel(2, 1), -0.375f);
}

}  // namespace
}  // namespace mirrorball
