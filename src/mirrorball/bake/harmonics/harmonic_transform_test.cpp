#include "mirrorball/bake/harmonics/harmonic_transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "formula/prefilter.h"
#include "mirrorball/bake/harmonics/legendre.h"
#include "mirrorball/bake/harmonics/spherical_harmonics.h"
#include "mirrorball/bake/prefilter/prefilter_testing.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

/// P̄_lm on one ring for l = m, m + 1, ….
std::vector<float> legendreOnRing(int m, int bands, double theta) {
  const LegendreOrder order(m, bands, legendreSeeds(m + 1).back());
  const double cosine = std::cos(theta);
  const double log2_sine = std::log2(std::sin(theta));
  LegendreBlock block(order, &cosine, &log2_sine, 1);
  std::vector<float> all;
  alignas(64) float values[kLegendreStretch * kLegendreBlock];
  for (int first = 0; m + first < bands; first += kLegendreStretch) {
    advance(order, first, block, values);
    for (int k = 0; k < kLegendreStretch; ++k)
      all.push_back(static_cast<float>(order.scale[std::size_t(first + k)]) * values[k * kLegendreBlock]);
  }
  return all;
}

TEST(Legendre, HasTheClosedFormsOfLowDegrees) {
  for (const double theta : {0.1, 0.8, 1.5}) {
    const double x = std::cos(theta);
    const double s = std::sin(theta);
    const double pi = std::numbers::pi;
    const std::vector<float> zero = legendreOnRing(0, 4, theta);
    EXPECT_NEAR(zero[0], std::sqrt(1 / (4 * pi)), 1e-6);
    EXPECT_NEAR(zero[1], std::sqrt(3 / (4 * pi)) * x, 1e-6);
    EXPECT_NEAR(zero[2], std::sqrt(5 / (16 * pi)) * (3 * x * x - 1), 1e-6);
    EXPECT_NEAR(zero[3], std::sqrt(7 / (16 * pi)) * x * (5 * x * x - 3), 1e-6);
    const std::vector<float> two = legendreOnRing(2, 5, theta);
    EXPECT_NEAR(two[0], std::sqrt(15 / (32 * pi)) * s * s, 1e-6);
    EXPECT_NEAR(two[1], std::sqrt(105 / (32 * pi)) * s * s * x, 1e-6);
  }
}

// Unsöld's theorem: Σ_m |Y_lm|² = (2l + 1) / 4π, here far beyond where sin^m θ leaves the range of a double.
TEST(Legendre, AddsUpToTheSumOfABandNearThePoleAndFarFromIt) {
  constexpr int kBand = 2500;
  for (const double theta : {0.02, 0.4, 1.2}) {
    double sum = 0.0;
    for (int m = 0; m <= kBand; ++m) {
      if (vanishes(m, kBand + 1, std::sin(theta))) continue;
      const auto value = static_cast<double>(legendreOnRing(m, kBand + 1, theta)[std::size_t(kBand - m)]);
      sum += (m == 0 ? 1.0 : 2.0) * value * value;
    }
    EXPECT_NEAR(sum * 4.0 * std::numbers::pi / (2 * kBand + 1), 1.0, 1e-4) << theta;
  }
}

/// Has no band beyond l = 6, and all orders.
glm::vec3 bandLimited(glm::vec3 d) {
  return {1.0f + d.x * d.y * d.z, 2.0f + std::pow(d.y, 5.0f) - d.x, 0.5f + d.x * d.x * d.z * d.z * d.y};
}

/// The greatest difference between a band-limited panorama and what synthesis makes of its coefficients.
float roundTripError(int height) {
  const EnvironmentMap panorama = panoramaOf(2 * height, height, bandLimited);
  const SphereGrid grid = *synthesize(*analyse(panorama, {}, 12), std::vector<float>(12, 1.0f), GridDensity::sparse);
  float error = 0.0f;
  PointBatch points;
  points.count = PointBatch::kCapacity;
  for (int i = 0; i < points.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    points.u[at] = std::fmod(0.37f * static_cast<float>(i), 1.0f);
    points.v[at] = (static_cast<float>(i) + 0.01f) / static_cast<float>(points.count);
  }
  std::array<glm::vec4, PointBatch::kCapacity> values;
  grid.sample(points, values.data());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const glm::vec3 truth = bandLimited(directionAt(Projection::equirect, {0, {points.u[i], points.v[i]}}));
    for (int c = 0; c < 3; ++c) error = std::max(error, std::abs(values[i][c] - truth[c]));
    error = std::max(error, std::abs(values[i].w - 1.0f));
  }
  return error;
}

TEST(HarmonicTransform, GivesABandLimitedPanoramaBack) {
  // The sum over texels is not the integral: 200 rows leave (π / 200)² / 24 at the poles.
  EXPECT_LT(roundTripError(200), 1e-3f);
}

TEST(HarmonicTransform, TakesOddAndPrimeSizes) {
  EXPECT_LT(roundTripError(199), 1e-3f);
  EXPECT_LT(roundTripError(127), 2e-3f);
}

TEST(HarmonicTransform, LeavesTheExcessOfBrightTexelsOut) {
  EnvironmentMap panorama = panoramaOf(64, 32, [](glm::vec3) { return glm::vec3(1.0f); });
  const HarmonicCoefficients expected = *analyse(panorama, {}, 8);
  const std::vector<glm::ivec2> places{{3, 5}, {9, 5}, {60, 27}};
  for (const glm::ivec2 place : places) panorama.face(0).texel(place.x, place.y)[1] += 5e3f;
  const BrightLights bright = brightLights(panorama, 16);
  ASSERT_EQ(bright.texels.size(), 3u);
  EnvironmentMap without = panorama;
  subtract(bright, without);
  const HarmonicCoefficients found = *analyse(panorama, bright, 8);
  const HarmonicCoefficients direct = *analyse(without, {}, 8);
  for (int m = 0; m < 8; ++m)
    for (int k = 0; m + k < 8; ++k) {
      EXPECT_NEAR(found.order(m)[std::size_t(k)].real.y, direct.order(m)[std::size_t(k)].real.y, 1e-4f);
      EXPECT_NEAR(found.order(m)[std::size_t(k)].imaginary.y, direct.order(m)[std::size_t(k)].imaginary.y, 1e-4f);
    }
}

/// The coefficients of a panorama by one sum over its texels.
Harmonics summed(const EnvironmentMap& panorama, int degree) {
  std::vector<glm::dvec3> sums(std::size_t((degree + 1) * (degree + 1)), glm::dvec3(0.0));
  const glm::ivec2 extent = panorama.extent();
  for (int y = 0; y < extent.y; ++y)
    for (int x = 0; x < extent.x; ++x) {
      const glm::vec3 d = directionAt(Projection::equirect, {0, (glm::vec2(x, y) + 0.5f) / glm::vec2(extent)});
      const glm::vec3 light = rgbAt(panorama.face(0), x, y) * texelSolidAngle(Projection::equirect, extent, {x, y});
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] += glm::dvec3(light * formula::harmonic(static_cast<int>(i), d));
    }
  return Harmonics(sums.begin(), sums.end());
}

TEST(SphericalHarmonics, AreThoseOfTheTexelsInOurAxes) {
  EnvironmentMap panorama = panoramaOf(256, 128, [](glm::vec3 d) {
    return glm::vec3(1.0f + d.x, 1.0f + d.y * d.z + 0.3f * d.x * d.y * d.z, 1.0f + d.z * d.z * d.x * d.y);
  });
  for (int c = 0; c < 3; ++c) panorama.face(0).texel(40, 30)[c] = 1e4f;
  const auto light = LightHarmonics::make(Environment(panorama), {Lobe::cosine()});
  const Harmonics found = radianceHarmonics(*light, 4);
  const Harmonics truth = summed(panorama, 4);
  ASSERT_EQ(found.size(), 25u);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[i][c], truth[i][c], 2e-5f * std::abs(truth[0][c])) << i;
}

// Ramamoorthi & Hanrahan 2001: light 1 + d·a gives irradiance π + 2π/3 (n·a); light (d·a)² gives π/3 + π/4
// ((n·a)² − 1/3).
TEST(SphericalHarmonics, OfIrradianceHaveThePublishedClosedForms) {
  const glm::vec3 a = glm::normalize(glm::vec3(1, 2, -3));
  const EnvironmentMap panorama = panoramaOf(
      512, 256, [a](glm::vec3 d) { return glm::vec3(1.0f + glm::dot(d, a), glm::dot(d, a) * glm::dot(d, a), 0.0f); });
  const auto light = LightHarmonics::make(Environment(panorama), {Lobe::cosine()});
  const Harmonics irradiance = irradianceOf(radianceHarmonics(*light, 2));
  const float pi = std::numbers::pi_v<float>;
  for (const glm::vec3 n : {glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(0.6f, -0.8f, 0), a, -a}) {
    glm::vec3 found(0.0f);
    for (int i = 0; i < 9; ++i) found += irradiance[std::size_t(i)] * formula::harmonic(i, n);
    const float cosine = glm::dot(n, a);
    EXPECT_NEAR(found.x, pi + 2.0f * pi / 3.0f * cosine, 3e-4f);
    EXPECT_NEAR(found.y, pi / 3.0f + pi / 4.0f * (cosine * cosine - 1.0f / 3.0f), 3e-4f);
    EXPECT_NEAR(found.z, 0.0f, 1e-6f);
  }
}

TEST(SphericalHarmonics, AreOrthonormal) {
  for (int i = 0; i < 25; ++i) {
    const EnvironmentMap one = panoramaOf(128, 64, [i](glm::vec3 d) { return glm::vec3(formula::harmonic(i, d)); });
    const Harmonics projected = summed(one, 4);
    for (int k = 0; k < 25; ++k) EXPECT_NEAR(projected[std::size_t(k)].x, i == k ? 1.0f : 0.0f, 1e-3f) << i << " " << k;
  }
}

TEST(SphericalHarmonics, WindowedFallWithTheBand) {
  const Harmonics window = windowed(Harmonics(25, glm::vec3(1.0f)));
  EXPECT_FLOAT_EQ(window[0].x, 1.0f);
  for (const std::size_t l : {1u, 2u, 3u, 4u}) EXPECT_LT(window[l * l].x, window[(l - 1) * (l - 1)].x);
  EXPECT_GT(window[24].x, 0.0f);
}

}  // namespace
}  // namespace mirrorball
