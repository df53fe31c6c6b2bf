#include "mirrorball/bake/prefilter/high_band_contrast.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/bake/prefilter/prefilter_testing.h"
#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

constexpr int kSourceRows = 32;

/// 1, and in one channel noise that differs from texel to texel.
EnvironmentMap noisyPanorama(float amplitude, int channel) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> noise(-amplitude, amplitude);
  return panoramaOf(2 * kSourceRows, kSourceRows, [&](glm::vec3) {
    glm::vec3 light(1.0f);
    light[channel] += noise(random);
    return light;
  });
}

/// 1 around a lamp.
EnvironmentMap panoramaWithLamp() {
  return panoramaOf(2 * kSourceRows, kSourceRows, [](glm::vec3 d) { return glm::vec3(d.x > 0.9f ? 10.0f : 1.0f); });
}

/// The power Σ_m |L_lm|² of one channel in each band below kSourceRows. By the addition theorem it is a sum over all
/// pairs of texels, (2 l + 1) / 4π Σ P_l(cos γ), each texel at its centre with its solid angle; in double.
std::vector<double> powersOfBands(const EnvironmentMap& panorama, int channel) {
  std::vector<glm::dvec3> directions;
  std::vector<double> fluxes;
  for (int y = 0; y < kSourceRows; ++y)
    for (int x = 0; x < 2 * kSourceRows; ++x) {
      const glm::vec2 uv((static_cast<float>(x) + 0.5f) / (2 * kSourceRows),
                         (static_cast<float>(y) + 0.5f) / kSourceRows);
      directions.emplace_back(directionAt(Projection::equirect, {0, uv}));
      fluxes.push_back(
          static_cast<double>(texelSolidAngle(Projection::equirect, {2 * kSourceRows, kSourceRows}, {x, y}) *
                              panorama.face(0).texel(x, y)[channel]));
    }
  std::vector<double> powers(kSourceRows, 0.0);
  for (std::size_t i = 0; i < fluxes.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const double product = (i == j ? 1.0 : 2.0) * fluxes[i] * fluxes[j];
      const double cosine = glm::dot(directions[i], directions[j]);
      double before = 0.0;
      double here = 1.0;  // P_l
      for (int l = 0; l < kSourceRows; ++l) {
        powers[std::size_t(l)] += product * here;
        before = std::exchange(here, ((2.0 * l + 1.0) * cosine * here - l * before) / (l + 1.0));
      }
    }
  for (int l = 0; l < kSourceRows; ++l) powers[std::size_t(l)] *= (2.0 * l + 1.0) / (4.0 * std::numbers::pi);
  return powers;
}

/// The light of the darkest of 16 × 32 parts.
double darkestPart(const EnvironmentMap& panorama, int channel) {
  constexpr int kSide = kSourceRows / 16;
  double darkest = std::numeric_limits<double>::infinity();
  for (int top = 0; top < kSourceRows; top += kSide)
    for (int left = 0; left < 2 * kSourceRows; left += kSide) {
      double sum = 0.0;
      for (int y = top; y < top + kSide; ++y)
        for (int x = left; x < left + kSide; ++x) sum += static_cast<double>(panorama.face(0).texel(x, y)[channel]);
      darkest = std::min(darkest, sum / (kSide * kSide));
    }
  return darkest;
}

/// What highBandContrast stands for, of the bands from `first` on: 4π times the mean power of a harmonic there.
double contrastOfBands(const EnvironmentMap& panorama, int channel, int first) {
  const std::vector<double> powers = powersOfBands(panorama, channel);
  const double power =
      std::accumulate(powers.begin() + first, powers.end(), 0.0) / (kSourceRows * kSourceRows - first * first);
  return std::sqrt(4.0 * std::numbers::pi * power) / darkestPart(panorama, channel);
}

TEST(HighBandContrast, OfEvenLightIsNone) {
  const EnvironmentMap map =
      panoramaOf(2 * kSourceRows, kSourceRows, [](glm::vec3) { return glm::vec3(0.1f, 1.0f, 300.0f); });
  EXPECT_NEAR(highBandContrast(map, {}), 0.0f, 1e-6f);
}

TEST(HighBandContrast, OfNoiseIsItsPowerInTheChannelThatHasMost) {
  for (int channel = 0; channel < 3; ++channel) {
    const EnvironmentMap map = noisyPanorama(0.5f, channel);
    const double truth = contrastOfBands(map, channel, kSourceRows / 2);
    // The power of so few harmonics and texels is random by some percent.
    EXPECT_NEAR(static_cast<double>(highBandContrast(map, {})), truth, 0.1 * truth) << channel;
  }
}

// In lower bands lamps have more than noise: their power in a harmonic falls by l³ while noise has the same in all.
TEST(HighBandContrast, OfALampIsMoreThanItsPowerInTheHighestBands) {
  const EnvironmentMap map = panoramaWithLamp();
  EXPECT_GT(static_cast<double>(highBandContrast(map, {})), contrastOfBands(map, 0, kSourceRows * 4 / 5));
}

TEST(HighBandContrast, IsTheSameForMoreLight) {
  EnvironmentMap map = panoramaWithLamp();
  const float contrast = highBandContrast(map, {});
  for (float& sample : map.face(0).samples()) sample *= 1000.0f;
  EXPECT_NEAR(highBandContrast(map, {}), contrast, 1e-4f * contrast);
}

TEST(HighBandContrast, IsAgainstTheDarkestPart) {
  EnvironmentMap map = noisyPanorama(0.5f, 0);
  const float contrast = highBandContrast(map, {});
  // A 16th of the height and a 32nd of the width, in the row of parts that begins at 8 / 16.
  const int side = kSourceRows / 16;
  const auto darkenPart = [&](float factor) {
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        for (int c = 0; c < 3; ++c) map.face(0).texel(5 * side + x, 8 * side + y)[c] *= factor;
  };
  darkenPart(0.01f);
  EXPECT_GT(highBandContrast(map, {}), 50.0f * contrast);
  darkenPart(0.0f);
  EXPECT_EQ(highBandContrast(map, {}), std::numeric_limits<float>::infinity());
}

TEST(HighBandContrast, DoesNotCountLightsThatAreToldOf) {
  EnvironmentMap map = noisyPanorama(0.5f, 1);
  const float contrast = highBandContrast(map, {});
  for (int c = 0; c < 3; ++c) map.face(0).texel(40, 20)[c] = 1e5f;
  EXPECT_GT(highBandContrast(map, {}), 1000.0f * contrast);
  const BrightLights sun = brightLights(map, 16);
  ASSERT_EQ(sun.texels.size(), 1u);
  const float without = highBandContrast(map, sun);
  EXPECT_LT(without, 2.0f * contrast) << "what it exceeds eight times the mean by is left out";
  subtract(sun, map);
  EXPECT_NEAR(highBandContrast(map, {}), without, 1e-5f * without);
}

TEST(HighBandContrast, SeesAcrossTheSidesOfThePanorama) {
  // Even but for one column, at a side and inside: the same contrast.
  const auto withColumn = [](int column) {
    EnvironmentMap map = panoramaOf(2 * kSourceRows, kSourceRows, [](glm::vec3) { return glm::vec3(1.0f); });
    for (int y = 0; y < kSourceRows; ++y) map.face(0).texel(column, y)[0] = 5.0f;
    return highBandContrast(map, {});
  };
  const float inside = withColumn(10);
  for (const int side : {0, 2 * kSourceRows - 1}) EXPECT_NEAR(withColumn(side), inside, 1e-4f * inside);
}

TEST(HighBandContrast, IsTheSameForGreyAndWithAFourthChannel) {
  EnvironmentMap map = noisyPanorama(0.5f, 0);
  const auto withChannels = [&](int channels) {
    Image image(2 * kSourceRows, kSourceRows, channels, 7.0f);
    for (int y = 0; y < kSourceRows; ++y)
      for (int x = 0; x < 2 * kSourceRows; ++x)
        for (int c = 0; c < std::min(channels, 3); ++c) image.texel(x, y)[c] = map.face(0).texel(x, y)[0];
    return highBandContrast(EnvironmentMap(Projection::equirect, ImageSet(std::move(image))), {});
  };
  const float contrast = withChannels(3);
  for (const int channels : {1, 4}) EXPECT_NEAR(withChannels(channels), contrast, 1e-5f * contrast) << channels;
}

TEST(HighBandContrast, AnyNumberOfThreadsGivesTheSameBits) {
  const EnvironmentMap map = noisyPanorama(0.5f, 2);
  const float contrast = highBandContrast(map, {});
  const testing::OneThread one_thread;
  EXPECT_EQ(highBandContrast(map, {}), contrast);
}

}  // namespace
}  // namespace mirrorball
