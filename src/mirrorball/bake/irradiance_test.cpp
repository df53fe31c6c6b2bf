#include "mirrorball/bake/irradiance.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "formula/formula.h"
#include "mirrorball/environment/convert.h"

namespace mirrorball {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

glm::vec3 irradianceAt(const IrradianceHarmonics& c, glm::vec3 n) {
  return formula::harmonicIrradiance(n, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]);
}

IrradianceHarmonics harmonicsOf(const RadianceFunction& radiance, Projection projection) {
  return irradianceHarmonics(*convert(Environment(radiance, 128), projection, 64));
}

TEST(Irradiance, OfAWhiteEnvironmentIsPi) {
  for (const Projection projection : {Projection::equirect, Projection::cube}) {
    const auto harmonics = harmonicsOf([](glm::vec3) { return glm::vec3(1.0f); }, projection);
    for (const glm::vec3 n : {glm::vec3(0, 1, 0), glm::vec3(0.6f, 0, -0.8f)})
      EXPECT_NEAR(irradianceAt(harmonics, n).x, kPi, 2e-4f * kPi) << "64 rows, each harmonic taken at its middle";
  }
}

// Closed forms: light 1 + d·a gives irradiance π + 2π/3 (n·a); light (d·a)² gives π/3 + π/4 ((n·a)² − 1/3).
TEST(Irradiance, OfLightUpToBandTwoIsExact) {
  const glm::vec3 a = glm::normalize(glm::vec3(1, 2, -3));
  const auto harmonics =
      harmonicsOf([a](glm::vec3 d) { return glm::vec3(1.0f + glm::dot(d, a), glm::dot(d, a) * glm::dot(d, a), 0.0f); },
                  Projection::cube);
  for (const glm::vec3 n : {glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(0.6f, -0.8f, 0), a, -a}) {
    const float cosine = glm::dot(n, a);
    const glm::vec3 irradiance = irradianceAt(harmonics, n);
    EXPECT_NEAR(irradiance.x, kPi + 2.0f * kPi / 3.0f * cosine, 3e-3f);
    EXPECT_NEAR(irradiance.y, kPi / 3.0f + kPi / 4.0f * (cosine * cosine - 1.0f / 3.0f), 3e-3f);
    EXPECT_NEAR(irradiance.z, 0.0f, 1e-6f);
  }
}

TEST(Irradiance, OfASmallLampIsNearAndNeverNegative) {
  const auto harmonics =
      harmonicsOf([](glm::vec3 d) { return glm::vec3(d.y > 0.98f ? 1.0f : 0.0f); }, Projection::equirect);
  const float head_on = kPi * (1.0f - 0.98f * 0.98f);  // ∫ cos θ dω over the cap
  EXPECT_NEAR(irradianceAt(harmonics, {0, 1, 0}).x, head_on, 0.1f * head_on);
  for (int step = 0; step <= 180; ++step) {
    const float angle = glm::radians(static_cast<float>(step));
    EXPECT_GE(irradianceAt(harmonics, {std::sin(angle), std::cos(angle), 0}).x, 0.0f);
  }
}

}  // namespace
}  // namespace mirrorball
