// FLIP is compared with the published program: the C++ header of github.com/NVlabs/flip, version 1.6, compiled by
// itself with g++ 12 and given the same pictures (flip_testing.h), which printed the numbers here. The same arithmetic
// in another order leaves a few units of a float's last place, which powers of nearly 0 make more of: hence 2e-6 for
// single pixels.
#include "mirrorball/metric/flip/flip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/base/range.h"
#include "mirrorball/metric/flip/flip_testing.h"

namespace mirrorball {
namespace {

using testing::asLight;
using testing::flipReference;
using testing::flipTest;

double meanOf(const Image& map) {
  double sum = 0.0;
  for (const float error : map.samples()) sum += double(error);
  return sum / static_cast<double>(map.texelCount());
}

/// What the published program says of one pair.
struct Published {
  int width;
  int height;
  float pixels_per_degree;
  double mean;
  double first;     ///< at (0, 0)
  double middle;    ///< at (width / 2, height / 2)
  double last;      ///< at (width − 1, height − 1)
  double in_noise;  ///< at (width / 6, height / 3)
  double in_ramp;   ///< at (5 · width / 6, height / 2)
};

void expectPublished(const Image& map, const Published& published) {
  const int width = published.width;
  const int height = published.height;
  SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height) + " at " +
               std::to_string(published.pixels_per_degree));
  EXPECT_NEAR(meanOf(map), published.mean, 1e-7);
  EXPECT_NEAR(double(*map.texel(0, 0)), published.first, 2e-6);
  EXPECT_NEAR(double(*map.texel(width / 2, height / 2)), published.middle, 2e-6);
  EXPECT_NEAR(double(*map.texel(width - 1, height - 1)), published.last, 2e-6);
  EXPECT_NEAR(double(*map.texel(width / 6, height / 3)), published.in_noise, 2e-6);
  EXPECT_NEAR(double(*map.texel(5 * width / 6, height / 2)), published.in_ramp, 2e-6);
}

TEST(LdrFlip, IsThePublishedOne) {
  for (const Published& published : {
           Published{61, 47, kUsualPixelsPerDegree, 0.271595497, 0.385112584, 0.300474286, 0.154904872, 0.0907842517,
                     0.366567075},
           Published{61, 47, 20.0f, 0.403052024, 0.661643088, 0.459800184, 0.110122673, 0.304947555, 0.327453971},
           Published{61, 47, 150.0f, 0.196367182, 0.296517521, 0.0686020553, 0.1963384, 0.0597798601, 0.376033098},
           Published{300, 70, kUsualPixelsPerDegree, 0.259128224, 0.385112584, 0.134069219, 0.118223801, 0.149093851,
                     0.350919574},
           Published{37, 1, kUsualPixelsPerDegree, 0.490606179, 0.412202358, 0.313032925, 0.878822207, 0.285433322,
                     0.861283898},
           Published{1, 1, kUsualPixelsPerDegree, 0.626028895, 0.626028895, 0.626028895, 0.626028895, 0.626028895,
                     0.626028895},
       }) {
    const Image test = flipTest(published.width, published.height);
    const Image reference = flipReference(published.width, published.height);
    expectPublished(*ldrFlip(test, reference, published.pixels_per_degree), published);
  }
}

/// Of a picture of one colour against one of another.
double flipOfColors(glm::vec3 a, glm::vec3 b) {
  Image first(9, 9, 3);
  Image second(9, 9, 3);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        first.texel(x, y)[channel] = a[channel];
        second.texel(x, y)[channel] = b[channel];
      }
  return meanOf(*ldrFlip(first, second, kUsualPixelsPerDegree));
}

TEST(LdrFlip, OfPlainColoursIsThePublishedOne) {
  EXPECT_NEAR(flipOfColors(glm::vec3(0.0f), glm::vec3(1.0f)), 0.967388332, 1e-6);
  EXPECT_NEAR(flipOfColors({0, 0, 1}, {0, 1, 0}), 1.0, 1e-6) << "as far apart as colours of a display are";
  EXPECT_NEAR(flipOfColors({1, 0, 0}, {0, 1, 0}), 0.986664951, 1e-6);
  EXPECT_NEAR(flipOfColors(glm::vec3(0.5f), glm::vec3(1.0f)), 0.531234443, 1e-6);
  EXPECT_EQ(flipOfColors(glm::vec3(1.0f), glm::vec3(3.0f)), 0.0) << "a display shows no more than white";
  EXPECT_EQ(flipOfColors(glm::vec3(0.0f), glm::vec3(-3.0f)), 0.0) << "and no less than black";
}

TEST(LdrFlip, LiesBetweenNothingAndOneAndIsSymmetric) {
  const Image test = flipTest(300, 70);
  const Image reference = flipReference(300, 70);
  const Image map = *ldrFlip(test, reference, kUsualPixelsPerDegree);
  const Image swapped = *ldrFlip(reference, test, kUsualPixelsPerDegree);
  for (std::size_t i = 0; i < map.samples().size(); ++i) {
    ASSERT_GE(map.samples()[i], 0.0f);
    ASSERT_LE(map.samples()[i], 1.0f);
    ASSERT_EQ(map.samples()[i], swapped.samples()[i]);
  }
  const Image nothing = *ldrFlip(test, test, kUsualPixelsPerDegree);
  for (const float error : nothing.samples()) ASSERT_EQ(error, 0.0f);
}

TEST(LdrFlip, AGreyImageIsThatInThreeChannels) {
  Image grey(20, 12, 1);
  Image colored(20, 12, 3);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 20; ++x) {
      *grey.texel(x, y) = static_cast<float>(x * y) / 240.0f;
      for (int channel = 0; channel < 3; ++channel) colored.texel(x, y)[channel] = *grey.texel(x, y);
    }
  const Image white(20, 12, 3, 1.0f);
  EXPECT_EQ(meanOf(*ldrFlip(grey, white, 30.0f)), meanOf(*ldrFlip(colored, white, 30.0f)));
}

TEST(HdrFlip, IsThePublishedOne) {
  struct Light {
    Published published;
    ExposureRange exposures;
  };
  for (const Light& light :
       {Light{{61, 47, kUsualPixelsPerDegree, 0.261788172, 0.223829597, 0.26989913, 0.0785552412, 0.123941652,
               0.292031229},
              {-15.52634f, 1.31254f, 17}},
        Light{{300, 70, 20.0f, 0.381415258, 0.585707843, 0.176901102, 0.0483886823, 0.351622939, 0.264253974},
              {-15.52634f, 1.21967f, 17}}}) {
    const Image test = asLight(flipTest(light.published.width, light.published.height));
    const Image reference = asLight(flipReference(light.published.width, light.published.height));
    const ExposureRange exposures = exposureRangeOf(reference);
    EXPECT_NEAR(exposures.start_ev, light.exposures.start_ev, 1e-5);
    EXPECT_NEAR(exposures.stop_ev, light.exposures.stop_ev, 1e-5);
    EXPECT_EQ(exposures.count, light.exposures.count);
    expectPublished(*hdrFlip(test, reference, exposures, light.published.pixels_per_degree), light.published);
  }
}

TEST(HdrFlip, ExposuresGoEvenlyFromFirstToLast) {
  const ExposureRange range{-3.0f, 5.0f, 5};
  EXPECT_EQ(range.at(0), -3.0f);
  EXPECT_EQ(range.at(1), -1.0f);
  EXPECT_EQ(range.at(4), 5.0f);
}

TEST(HdrFlip, ExposuresOfAReferenceThatIsMostlyBlackAreThoseOfTheRest) {
  Image reference(10, 10, 3);
  EXPECT_EQ(exposureRangeOf(reference).start_ev, 0.0f) << "black";
  EXPECT_EQ(exposureRangeOf(reference).stop_ev, 0.0f) << "black";
  for (int x = 0; x < 5; ++x)
    for (int channel = 0; channel < 3; ++channel) reference.texel(x, 3)[channel] = std::exp2(static_cast<float>(x));
  const ExposureRange range = exposureRangeOf(reference);
  EXPECT_NEAR(range.stop_ev - range.start_ev, 2.0f, 1e-5) << "from 4, the median of 1 … 16, to 16";
  EXPECT_EQ(range.count, 2);
}

TEST(HdrFlip, IsNothingForEqualLightHoweverBrightAndNoneIsNegative) {
  Image light = asLight(flipReference(40, 30));
  light.texel(3, 3)[0] = 3e38f;
  light.texel(4, 3)[1] = -2.0f;
  const Image map = *hdrFlip(light, light, exposureRangeOf(light), kUsualPixelsPerDegree);
  for (const float error : map.samples()) ASSERT_EQ(error, 0.0f);
  const Image black(8, 8, 3);
  const Image negative(8, 8, 3, -5.0f);
  EXPECT_EQ(meanOf(*hdrFlip(negative, black, exposureRangeOf(black), kUsualPixelsPerDegree)), 0.0);
}

TEST(HdrFlip, LightOfAnySizeHasExposuresThatAreNumbers) {
  for (const float light : {1e-45f, 1e-38f, 1e38f, 3.4e38f}) {
    const Image reference(6, 6, 3, light);
    const ExposureRange range = exposureRangeOf(reference);
    EXPECT_TRUE(std::isfinite(range.start_ev) && std::isfinite(range.stop_ev)) << light;
    EXPECT_EQ(range.count, 2) << light;
    EXPECT_TRUE(std::isfinite(meanOf(*hdrFlip(Image(6, 6, 3), reference, range, kUsualPixelsPerDegree)))) << light;
  }
}

TEST(HdrFlip, ADifferenceInTheDarkIsSeenUnderASun) {
  Image reference(40, 40, 3, 0.01f);
  for (int channel = 0; channel < 3; ++channel) reference.texel(2, 2)[channel] = 1e5f;
  Image test = reference;
  for (int channel = 0; channel < 3; ++channel) test.texel(30, 30)[channel] = 0.02f;
  const Image map = *hdrFlip(test, reference, exposureRangeOf(reference), kUsualPixelsPerDegree);
  EXPECT_GT(*map.texel(30, 30), 0.1f);
  EXPECT_EQ(*map.texel(2, 2), 0.0f);
}

TEST(HdrFlip, AnyNumberOfThreadsGivesTheSameBits) {
  const Image test = asLight(flipTest(300, 140));
  const Image reference = asLight(flipReference(300, 140));
  const Image many = *hdrFlip(test, reference, {-2.0f, 3.0f, 3}, kUsualPixelsPerDegree);
  const testing::OneThread one;
  const Image single = *hdrFlip(test, reference, {-2.0f, 3.0f, 3}, kUsualPixelsPerDegree);
  EXPECT_TRUE(areEqual(many.samples(), single.samples()));
}

TEST(HdrFlip, StopsWhenItIsTold) {
  const Image light(8, 8, 3, 1.0f);
  const auto stopped = hdrFlip(light, light, {}, kUsualPixelsPerDegree, [](auto, auto) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
