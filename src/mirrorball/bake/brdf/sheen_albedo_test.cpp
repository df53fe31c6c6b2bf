#include "mirrorball/bake/brdf/sheen_albedo.h"

#include <cmath>

#include <gtest/gtest.h>

#include "formula/bsdf.h"

namespace mirrorball {
namespace {

// A sum over places of equal weight on the hemisphere, which shares nothing with the table's rule.
double summed(float roughness, float cosine) {
  constexpr int kSteps = 700;
  const float alpha = formula::alphaOfSheen(roughness);
  const glm::vec3 v(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const float z = (static_cast<float>(i) + 0.5f) / kSteps;
      const float around = formula::kTwoPi * (static_cast<float>(j) + 0.5f) / kSteps;
      const float sine = std::sqrt(1.0f - z * z);
      sum += double(formula::evalCharlie(alpha, v, {sine * std::cos(around), sine * std::sin(around), z}) * z);
    }
  return sum * double(formula::kTwoPi) / (double(kSteps) * kSteps);
}

TEST(SheenAlbedo, IsTheIntegralOfTheFormula) {
  for (const float roughness : {0.15f, 0.4f, 0.73f, 1.0f})
    for (const float cosine : {0.06f, 0.2f, 0.55f, 0.9f, 1.0f})
      EXPECT_NEAR(sheenAlbedo(roughness, cosine), summed(roughness, cosine), 2e-3) << roughness << ", " << cosine;
}

TEST(SheenAlbedo, IsAShare) {
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) {
      const float share = sheenAlbedo(static_cast<float>(i) / 40, static_cast<float>(j) / 40);
      EXPECT_GE(share, 0.0f);
      EXPECT_LE(share, 1.0f);
    }
}

}  // namespace
}  // namespace mirrorball
