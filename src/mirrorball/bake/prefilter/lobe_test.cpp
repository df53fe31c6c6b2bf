#include "mirrorball/bake/prefilter/lobe.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "formula/prefilter.h"
#include "mirrorball/bake/harmonics/gauss_legendre.h"

namespace mirrorball {
namespace {

TEST(GaussLegendre, IsExactForPolynomials) {
  const QuadratureRule rule = gaussLegendre(8);
  for (int power = 0; power < 16; ++power) {
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.places.size(); ++i) sum += rule.weights[i] * std::pow(rule.places[i], power);
    EXPECT_NEAR(sum, power % 2 == 0 ? 2.0 / (power + 1) : 0.0, 1e-13) << power;
  }
}

// Ramamoorthi & Hanrahan 2001: A0 = π, A1 = 2π/3, A2 = π/4, A3 = 0, A4 = −π/24; the lobe is divided by π.
TEST(Lobe, CosineHasThePublishedBands) {
  const Lobe cosine = Lobe::cosine();
  ASSERT_GT(cosine.bands().size(), 5u);
  for (int l = 0; l <= 4; ++l)
    EXPECT_NEAR(cosine.bands()[std::size_t(l)], formula::cosineLobeBand(l) / std::numbers::pi_v<float>, 1e-6f) << l;
  EXPECT_NEAR(cosine.bands()[6], 1.0f / 64.0f, 1e-6f);  // A6 = π/64
}

// 1.0e-2 is narrow enough for the sphere to be a plane, on which (1 + (θ/2α)²)^-2 has the transform x K₁(x), x = 2αl.
TEST(Lobe, NarrowGgxHasTheBandsOfItsTransformInThePlane) {
  const float alpha = 0.01f;
  const Lobe lobe = Lobe::reflection(Distribution::ggx, std::sqrt(alpha));
  const auto besselK1 = [](double x) {  // ∫ e^(−x cosh t) cosh t dt
    double sum = 0.0;
    for (double t = 0.0; t < 8.0; t += 1e-3) sum += std::exp(-x * std::cosh(t)) * std::cosh(t) * 1e-3;
    return sum;
  };
  for (const int l : {10, 50, 100, 200, 300}) {
    const double x = 2.0 * 0.01 * (l + 0.5);
    EXPECT_NEAR(lobe.bands()[std::size_t(l)], x * besselK1(x), 2e-3) << l;
  }
}

TEST(Lobe, IntegratesToOne) {
  for (const Distribution distribution :
       {Distribution::ggx, Distribution::phong, Distribution::blinn, Distribution::charlie})
    for (const float roughness : {0.0872f, 0.3f, 0.7f, 1.0f}) {
      const Lobe lobe = Lobe::reflection(distribution, roughness);
      // In steps of log s, dω = 4π ds.
      double sum = 0.0;
      constexpr int kSteps = 200000;
      const double first = std::log(1e-12);
      const double step = (std::log(0.5) - first) / kSteps;
      for (int i = 0; i < kSteps; ++i) {
        const double s = std::exp(first + (i + 0.5) * step);
        sum += static_cast<double>(lobe.at(static_cast<float>(s))) * 4.0 * std::numbers::pi * s * step;
      }
      EXPECT_NEAR(sum, 1.0, 1e-4) << static_cast<int>(distribution) << " " << roughness;
      EXPECT_NEAR(lobe.bands()[0], 1.0f, 1e-6f);
    }
}

TEST(Lobe, RougherIsWider) {
  float before = 1.0f;
  for (const float roughness : {0.1f, 0.2f, 0.4f, 0.8f, 1.0f}) {
    const float band = Lobe::reflection(Distribution::ggx, roughness).bands()[2];
    EXPECT_LT(std::abs(band), before);
    before = std::abs(band);
  }
}

TEST(Lobe, LessToleranceTakesMoreBands) {
  const Lobe lobe = Lobe::reflection(Distribution::ggx, 0.09f);
  EXPECT_GT(lobe.bandsFor(1e-4f), lobe.bandsFor(1e-2f));
  EXPECT_EQ(lobe.bandsFor(0.0f), static_cast<int>(lobe.bands().size()));
  EXPECT_EQ(Lobe::reflection(Distribution::ggx, 0.14f).bandsFor(1e3f), Lobe::kCheapBands);
}

TEST(Lobe, NoToleranceLeavesOutWhatPatternsMayHaveAllTheirLightIn) {
  const Lobe lobe = Lobe::reflection(Distribution::ggx, 0.09f);
  const auto taken = static_cast<std::size_t>(lobe.bandsFor(1e3f));
  ASSERT_LT(taken, lobe.bands().size());
  EXPECT_GT(lobe.bands()[taken - 1], Lobe::kMaxLeftOut);
  for (std::size_t l = taken; l < lobe.bands().size(); ++l) EXPECT_LE(std::abs(lobe.bands()[l]), Lobe::kMaxLeftOut);
}

}  // namespace
}  // namespace mirrorball
