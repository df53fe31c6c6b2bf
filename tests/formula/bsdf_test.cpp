// BSDFs: what a sampler draws has the density that its pdf says, densities add up to 1, and light goes both ways alike.

#include "formula/bsdf.h"

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "chi_squared.h"

namespace mirrorball::formula {
namespace {

/// Directions are counted in bands of equal cosine and sectors of equal azimuth, over the whole sphere.
constexpr int kBands = 16;
constexpr int kSectors = 24;
constexpr int kDrawn = 200000;

/// Bins of a density are sums over so many places: the narrowest lobe tested, alpha = 0.2, fills 0.04 of a cosine.
constexpr int kPlacesAlongBand = 160;
constexpr int kPlacesAlongSector = 24;

using Sample = std::function<vec3(vec2)>;
using Density = std::function<float(vec3)>;

vec3 directionAt(double cosine, double azimuth) {
  const double sine = std::sqrt(1.0 - cosine * cosine);
  return vec3(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
}

/// How many of the directions are to be expected in each bin.
std::vector<double> expectedIn(const Density& density) {
  std::vector<double> expected(kBands * kSectors, 0.0);
  const double solid_angle = 2.0 / (kBands * kPlacesAlongBand) * kTwoPi / (kSectors * kPlacesAlongSector);
  for (int y = 0; y < kBands * kPlacesAlongBand; ++y)
    for (int x = 0; x < kSectors * kPlacesAlongSector; ++x) {
      const vec3 d = directionAt(2.0 * (y + 0.5) / (kBands * kPlacesAlongBand) - 1.0,
                                 kTwoPi * (x + 0.5) / (kSectors * kPlacesAlongSector));
      expected[std::size_t(y / kPlacesAlongBand * kSectors + x / kPlacesAlongSector)] +=
          kDrawn * solid_angle * double(density(d));
    }
  return expected;
}

std::vector<double> countedIn(const Sample& sample) {
  std::vector<double> counted(kBands * kSectors, 0.0);
  std::mt19937 random(20261122);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (int i = 0; i < kDrawn; ++i) {
    const float u = uniform(random);
    const vec3 d = sample({u, uniform(random)});
    EXPECT_NEAR(length(d), 1.0f, 1e-4f);
    const int band = std::clamp(static_cast<int>((d.z + 1.0f) / 2.0f * kBands), 0, kBands - 1);
    const float azimuth = std::atan2(d.y, d.x) / kTwoPi;
    counted[std::size_t(band * kSectors + std::clamp(static_cast<int>((azimuth - std::floor(azimuth)) * kSectors), 0,
                                                     kSectors - 1))] += 1;
  }
  return counted;
}

void expectDrawn(const Sample& sample, const Density& density, const std::string& what) {
  testing::expectCounts(countedIn(sample), expectedIn(density), what);
}

const std::vector<vec3> kEyes{vec3(0, 0, 1), directionAt(0.7, 0.4), directionAt(0.15, 4.0)};

TEST(Bsdf, DiffuseIsDrawnByItsDensity) {
  expectDrawn([](vec2 u) { return sampleDiffuse(u); }, [](vec3 l) { return pdfDiffuse(l); }, "diffuse");
}

TEST(Bsdf, VisibleNormalsAreDrawnByTheirDensity) {
  for (const float alpha : {0.2f, 0.5f, 1.0f})
    for (const vec3 v : kEyes)
      expectDrawn([&](vec2 u) { return sampleVisibleNormal(vec2(alpha), v, u); },
                  [&](vec3 h) { return pdfVisibleNormal(vec2(alpha), v, h); },
                  "alpha " + std::to_string(alpha) + ", v.z " + std::to_string(v.z));
}

TEST(Bsdf, GgxIsDrawnByItsDensityBelowTheHorizonToo) {
  for (const float alpha : {0.3f, 1.0f})
    for (const vec3 v : kEyes)
      expectDrawn([&](vec2 u) { return sampleGgx(vec2(alpha), v, u); },
                  [&](vec3 l) { return pdfGgx(vec2(alpha), v, l); },
                  "alpha " + std::to_string(alpha) + ", v.z " + std::to_string(v.z));
}

TEST(Bsdf, PhongIsDrawnByItsDensity) {
  for (const float exponent : {1.0f, 8.0f, 40.0f})
    for (const vec3 v : kEyes)
      expectDrawn([&](vec2 u) { return samplePhong(exponent, v, u); }, [&](vec3 l) { return pdfPhong(exponent, v, l); },
                  "exponent " + std::to_string(exponent));
}

TEST(Bsdf, LightGoesBothWaysAlike) {
  for (const float alpha : {0.05f, 0.4f, 1.0f})
    for (const vec3 v : kEyes)
      for (const vec3 l : {directionAt(0.9, 1.0), directionAt(0.3, 3.0), directionAt(0.05, 5.0)}) {
        const float there = evalGgx(vec2(alpha), v, l);
        EXPECT_NEAR(evalGgx(vec2(alpha), l, v), there, 1e-5f * std::max(there, 1.0f)) << alpha;
        EXPECT_NEAR(evalPhong(20.0f, l, v), evalPhong(20.0f, v, l), 1e-5f);
      }
  EXPECT_EQ(evalGgx(vec2(0.5f), kEyes[1], directionAt(-0.2, 0.0)), 0.0f) << "below the horizon";
}

/// What white facets send away at the first bounce: those that the eye sees, as far as the light is not hidden.
float singleScattering(vec2 alpha, vec3 v) {
  constexpr int kSteps = 200;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const vec2 u = (vec2(i, j) + 0.5f) / float(kSteps);
      const vec3 l = sampleGgx(alpha, v, u);
      if (l.z > 0.0f) sum += double(ggxMaskingShadowing(alpha, v, l) / ggxMasking(alpha, v));
    }
  return static_cast<float>(sum / (kSteps * kSteps));
}

// Facets that are stretched hide each other as wide ones do: along their grooves as across them.
TEST(Bsdf, StretchedFacetsSendAwayWhatTheirStepsSay) {
  for (const vec2 alpha : {vec2(1.0f, 0.04f), vec2(0.5f, 0.04f), vec2(0.25f, 0.25f)})
    for (const float cosine : {0.95f, 0.6f, 0.25f})
      for (const float azimuth : {0.0f, 0.8f, 1.57f}) {
        const float sine = std::sqrt(1.0f - cosine * cosine);
        const vec3 v(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
        const float round = singleScattering(vec2(alpha.y), v);
        EXPECT_NEAR(round * stretchedShare(alpha, v), singleScattering(alpha, v), 0.04f)
            << alpha.x << ", " << alpha.y << ", " << cosine << ", " << azimuth;
      }
}

// The facets' areas, projected, are the surface's (Walter et al. 2007, eq. 4); those seen from v are v's share of it.
TEST(Bsdf, FacetsCoverTheSurface) {
  constexpr int kSteps = 4000;
  for (const float alpha : {0.1f, 0.5f, 1.0f}) {
    double area = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double sine2 = (i + 0.5) / kSteps;  // d(sin²) = 2 cos sin dθ
      area += double(ggxDistribution(vec2(alpha), directionAt(std::sqrt(1.0 - sine2), 0.0))) * kTwoPi / 2.0 / kSteps;
    }
    EXPECT_NEAR(area, 1.0, 2e-3) << alpha;
  }
}

}  // namespace
}  // namespace mirrorball::formula
