#include "mirrorball/image/filter.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

float atColumn(float position, float (*value)(float)) {
  return bicubic({position, 3.0f}, [&](int x, int) { return glm::vec4(glm::vec3(value(static_cast<float>(x))), 1.0f); })
      .x;
}

TEST(Bicubic, IsExactOnParabolas) {
  const auto parabola = [](float x) { return 1.0f + 0.5f * x + 0.25f * x * x; };
  for (float x = 2.0f; x < 6.0f; x += 0.125f) EXPECT_NEAR(atColumn(x + 0.5f, parabola), parabola(x), 1e-5f) << x;
}

TEST(Bicubic, BesideABrightTexelNothingIsDarkerThanTheTexels) {
  const auto sun = [](float x) { return x == 4.0f ? 1e5f : 0.25f; };
  for (float x = 1.0f; x < 8.0f; x += 0.0625f) {
    EXPECT_GE(atColumn(x, sun), 0.25f) << x;
    EXPECT_LE(atColumn(x, sun), 1e5f) << x;
  }
  const auto negative = [](float) { return -2.0f; };
  EXPECT_NEAR(atColumn(4.3f, negative), -2.0f, 1e-5f);
  const auto max = [](float x) { return x == 4.0f ? 3e38f : 1.0f; };
  for (float x = 1.0f; x < 8.0f; x += 0.25f) EXPECT_TRUE(std::isfinite(atColumn(x, max))) << x;
}

TEST(Bicubic, NoneOfTheColoursOfASunsEdgeIsMissing) {
  const auto fetch = [](int x, int) {
    return x < 4 ? glm::vec4(0.2f, 0.5f, 1.0f, 1.0f) : glm::vec4(1e5f, 2e4f, 1.5f, 1.0f);
  };
  for (float x = 1.0f; x < 8.0f; x += 0.0625f) {
    const glm::vec4 light = bicubic({x, 3.0f}, fetch);
    const float share = (light.x - 0.2f) / (1e5f - 0.2f);
    EXPECT_NEAR(light.y, glm::mix(0.5f, 2e4f, share), 0.01f) << x;
    EXPECT_NEAR(light.z, glm::mix(1.0f, 1.5f, share), 1e-4f) << x;
  }
}

TEST(Bicubic, APeakBetweenTexelsRisesAboveThem) {
  const auto peak = [](float x) { return 2.0f - 0.1f * (x - 4.5f) * (x - 4.5f); };
  EXPECT_NEAR(atColumn(5.0f, peak), 2.0f, 1e-6f);
}

TEST(Bicubic, TheLineAcrossAStepBends) {
  const auto step = [](int, int y) { return glm::vec4(glm::vec3(y < 3 ? 1000.0f : 0.0f), 1.0f); };
  EXPECT_NEAR(bicubic({3.0f, 3.0f}, step, 0.2f).x, 1000.0f * (1.0f - (0.5f + 0.2f / 4.0f)), 1e-3f);
  const auto ramp = [](int, int y) { return glm::vec4(glm::vec3(10.0f + static_cast<float>(y)), 1.0f); };
  EXPECT_NEAR(bicubic({3.0f, 3.0f}, ramp, 0.2f).x, 12.5f, 1e-5f);  // of little contrast: the cubic
}

TEST(Bicubic, IsBilinearWhereATexelIsMissing) {
  const auto fetch = [](int x, int y) { return glm::vec4(glm::vec3(static_cast<float>(x + y)), x < 5 ? 1.0f : 0.0f); };
  const glm::vec2 position(4.2f, 3.7f);
  EXPECT_EQ(bicubic(position, fetch), bilinear(position, fetch));
}

}  // namespace
}  // namespace mirrorball
