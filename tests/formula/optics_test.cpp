#include <cmath>

#include <gtest/gtest.h>

#include "formula/bsdf.h"

namespace mirrorball::formula {
namespace {

const float kDegree = kPi / 180.0f;

TEST(Optics, SnellBendsTheRay) {
  // 30° in air are 19.47° in glass of 1.5: sin θ2 = 0.5 / 1.5.
  const vec3 ray(std::sin(30.0f * kDegree), -std::cos(30.0f * kDegree), 0.0f);
  const vec3 inside = refractedDirection(ray, vec3(0, 1, 0), 1.5f);
  EXPECT_NEAR(inside.x, 1.0f / 3.0f, 1e-6f);
  EXPECT_LT(inside.y, 0.0f);
  EXPECT_NEAR(length(inside), 1.0f, 1e-6f);
}

TEST(Optics, PastTheCriticalAngleTheRayReflects) {
  // From water to air the critical angle is asin(1 / 1.333) = 48.6°.
  const auto leaving = [](float degrees) {
    return refractedDirection(vec3(std::sin(degrees * kDegree), -std::cos(degrees * kDegree), 0.0f), vec3(0, 1, 0),
                              1.0f / 1.333f);
  };
  EXPECT_LT(leaving(48.0f).y, 0.0f);
  EXPECT_GT(leaving(49.0f).y, 0.0f);
  EXPECT_NEAR(leaving(60.0f).x, std::sin(60.0f * kDegree), 1e-6f);
  EXPECT_EQ(fresnelDielectric(std::cos(49.0f * kDegree), 1.0f / 1.333f), 1.0f);
  EXPECT_LT(fresnelDielectric(std::cos(48.0f * kDegree), 1.0f / 1.333f), 0.5f);
}

TEST(Optics, FresnelOfADielectricHasItsKnownValues) {
  EXPECT_NEAR(fresnelDielectric(1.0f, 1.5f), 0.04f, 1e-6f);
  EXPECT_NEAR(fresnelDielectric(1.0f, 1.0f / 1.5f), 0.04f, 1e-6f) << "at normal incidence, both ways";
  EXPECT_NEAR(fresnelDielectric(0.0f, 1.5f), 1.0f, 1e-6f);
  // At Brewster's angle, tan θ = n, only the perpendicular part is left: ((1 − n²) / (1 + n²))² / 2.
  const float n = 1.5f;
  const float brewster = (1.0f - n * n) / (1.0f + n * n);
  EXPECT_NEAR(fresnelDielectric(std::cos(std::atan(n)), n), brewster * brewster / 2.0f, 1e-6f);
}

TEST(Optics, FresnelOfAConductorHasItsKnownValues) {
  // Head on ((n − 1)² + k²) / ((n + 1)² + k²); without absorption it is a dielectric's at every angle.
  EXPECT_NEAR(fresnelConductor1(1.0f, 0.156f, 3.602f), (0.844f * 0.844f + 12.9744f) / (1.156f * 1.156f + 12.9744f),
              1e-5f);
  for (float cosine = 0.05f; cosine <= 1.0f; cosine += 0.05f)
    EXPECT_NEAR(fresnelConductor1(cosine, 1.5f, 0.0f), fresnelDielectric(cosine, 1.5f), 1e-5f) << cosine;
}

// Schlick's form is known to be off by up to 0.036 at n = 1.5; the seeds' form, fitted, by less than half of that.
TEST(Optics, TheEmpiricalFormCanBeFittedBetterThanSchlicks) {
  float schlick = 0.0f;
  float fitted = 0.0f;
  for (float cosine = 0.0f; cosine <= 1.0f; cosine += 1.0f / 256.0f) {
    const float exact = fresnelDielectric(cosine, 1.5f);
    schlick = std::max(schlick, std::abs(fresnelSchlick(cosine, vec3(0.04f)).x - exact));
    fitted = std::max(fitted, std::abs(fresnelEmpirical(cosine, 0.033f, 0.953f, 5.2f) - exact));
  }
  EXPECT_NEAR(schlick, 0.036f, 0.004f);
  EXPECT_LT(fitted, schlick);
}

TEST(Optics, DispersionHasAbbesNumber) {
  // BK7: n_d = 1.5168, V = 64.17, n_F − n_C = 0.00806 (Schott's catalogue).
  const vec3 ior = iorOfChannels(1.5168f, 20.0f / 64.17f);
  EXPECT_NEAR(ior.z - ior.x, 0.00806f, 2e-5f);
  EXPECT_EQ(ior.y, 1.5168f);
}

// Schott BK7: n_d 1.5168, V 64.17; n_F 1.52238, n_C 1.51432, and at the line g (435.8 nm) 1.52668.
TEST(Optics, TheIndexOfAGlassFollowsTheWavelength) {
  const float dispersion = 20.0f / 64.17f;
  EXPECT_NEAR(iorAtWavelength(1.5168f, dispersion, 0.58756f), 1.5168f, 1e-6f);
  EXPECT_NEAR(iorAtWavelength(1.5168f, dispersion, 0.48613f), 1.52238f, 2e-4f);
  EXPECT_NEAR(iorAtWavelength(1.5168f, dispersion, 0.65627f), 1.51432f, 2e-4f);
  EXPECT_NEAR(iorAtWavelength(1.5168f, dispersion, 0.4358f), 1.52668f, 1e-3f) << "Cauchy's two terms end here";
  const vec3 channels = iorOfChannels(1.5168f, dispersion);
  EXPECT_NEAR(channels.z - channels.x,
              iorAtWavelength(1.5168f, dispersion, 0.48613f) - iorAtWavelength(1.5168f, dispersion, 0.65627f), 1e-5f);
}

}  // namespace
}  // namespace mirrorball::formula
