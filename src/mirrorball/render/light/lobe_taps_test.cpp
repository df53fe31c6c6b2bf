#include "mirrorball/render/light/lobe_taps.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

constexpr float kTexel = 2.0f / 256.0f;

/// P_l, by its recurrence.
double legendre(int band, double x) {
  double before = 1.0;
  double here = x;
  if (band == 0) return before;
  for (int l = 1; l < band; ++l) {
    const double next = ((2.0 * l + 1.0) * x * here - l * before) / (l + 1.0);
    before = here;
    here = next;
  }
  return here;
}

/// What taps leave of band l, each blurring like a Gaussian of its variance.
double bandOfTaps(const std::vector<LobeTap>& taps, int band) {
  double sum = 0.0;
  for (const LobeTap& tap : taps) {
    const auto footprint = static_cast<double>(tap.footprint_rad);
    const double variance = footprint * footprint * 5 / 12 - double(kTexel) * double(kTexel) / 4;
    const double cosine = std::sqrt(1.0 - static_cast<double>(glm::dot(tap.place, tap.place)));
    sum += static_cast<double>(tap.weight) * legendre(band, cosine) * std::exp(-0.5 * band * (band + 1.0) * variance);
  }
  return sum;
}

TEST(LobeTaps, WeightsArePositiveAndSumToOne) {
  for (const float roughness : {0.087f, 0.3f, 0.6f, 1.0f}) {
    const Lobe lobe = Lobe::reflection(Distribution::ggx, roughness);
    double sum = 0.0;
    for (const LobeTap& tap : lobeTaps(lobe, kTexel, 8, 8)) {
      EXPECT_GE(tap.weight, 0.0f) << roughness;
      EXPECT_GE(tap.footprint_rad, kTexel) << roughness;
      EXPECT_LT(glm::length(tap.place), 1.0f) << roughness;
      sum += static_cast<double>(tap.weight);
    }
    EXPECT_NEAR(sum, 1.0, 1e-5) << roughness;
  }
}

TEST(LobeTaps, LeaveOfEachBandWhatTheLobeDoes) {
  for (const float roughness : {0.18f, 0.3f, 0.42f, 0.6f, 1.0f}) {
    const Lobe lobe = Lobe::reflection(Distribution::ggx, roughness);
    const std::vector<LobeTap> taps = lobeTaps(lobe, kTexel, 8, 8);
    for (const int band : {1, 2, 3, 4, 6, 8, 12, 16, 24})
      EXPECT_NEAR(bandOfTaps(taps, band), static_cast<double>(lobe.bands()[static_cast<std::size_t>(band)]), 0.012)
          << "roughness " << roughness << ", band " << band << ": 64 taps leave less than 1.2 % of a band's light";
  }
}

TEST(LobeTaps, MoreTapsComeCloser) {
  const Lobe lobe = Lobe::reflection(Distribution::ggx, 0.3f);
  const auto worst = [&](int rings, int points) {
    const std::vector<LobeTap> taps = lobeTaps(lobe, kTexel, rings, points);
    double largest = 0.0;
    for (int band = 1; band < 32; ++band)
      largest = std::max(largest, std::abs(bandOfTaps(taps, band) -
                                           static_cast<double>(lobe.bands()[static_cast<std::size_t>(band)])));
    return largest;
  };
  EXPECT_LT(worst(12, 12), 0.5 * worst(4, 8));
}

}  // namespace
}  // namespace mirrorball
