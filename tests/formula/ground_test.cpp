#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "formula/color.h"
#include "formula/sky.h"

namespace mirrorball::formula {
namespace {

constexpr float kTexel_rad = 0.003f;

TEST(Ground, NoiseIsSmoothAndFillsItsRange) {
  float min = 1.0f;
  float max = 0.0f;
  double sum = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const vec2 place(0.0137f * static_cast<float>(i), -0.0071f * static_cast<float>(i));
    const float here = groundNoise(place);
    EXPECT_NEAR(groundNoise(place + 1e-3f), here, 4e-3f) << "at " << place.x << ", " << place.y;
    min = std::min(min, here);
    max = std::max(max, here);
    sum += double(here);
  }
  EXPECT_GE(min, 0.0f);
  EXPECT_LE(max, 1.0f);
  EXPECT_GT(max - min, 0.9f);
  EXPECT_NEAR(sum / kSteps, 0.5, 0.03);
}

TEST(Ground, ReflectsAFifthOnAverage) {
  double sum = 0.0;
  constexpr int kSide = 200;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      sum += double(luminance(groundAlbedo(groundPattern(vec2(x, y) * 0.37f, 1.0f, kTexel_rad))));
  EXPECT_NEAR(sum / (kSide * kSide), 0.2, 0.01);
}

TEST(Ground, HasNoDetailThatATexelCannotShow) {
  EXPECT_EQ(groundPattern(vec2(100.3f, 7.1f), 0.01f, kTexel_rad), vec2(0.0f));
  EXPECT_NE(groundPattern(vec2(1.3f, 0.1f), 0.6f, kTexel_rad), vec2(0.0f));
}

TEST(Ground, FadesIntoTheSkyAtTheHorizon) {
  const vec3 horizon(0.7f, 0.6f, 0.5f);
  const vec3 light =
      groundRadiance(normalize(vec3(1, -1e-4f, 0)), vec3(0, 1, 0), vec3(3), vec3(1), horizon, kTexel_rad);
  EXPECT_LT(length(light - horizon), 0.01f);
}

}  // namespace
}  // namespace mirrorball::formula
