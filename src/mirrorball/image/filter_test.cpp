#include "mirrorball/image/filter.h"

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

TEST(Bicubic, WeightsSumToOneAndAreOneTexelsAtItsCentre) {
  for (float t = 0.0f; t <= 1.0f; t += 0.0625f) {
    const auto weights = catmullRomWeights(t);
    EXPECT_NEAR(weights[0] + weights[1] + weights[2] + weights[3], 1.0f, 1e-6f);
  }
  EXPECT_EQ(catmullRomWeights(0.0f), (std::array<float, 4>{0.0f, 1.0f, 0.0f, 0.0f}));
}

TEST(Bicubic, BesideABrightTexelNothingIsNegative) {
  const auto sun = [](float x) { return x == 4.0f ? 1e5f : 0.25f; };
  for (float x = 1.0f; x < 8.0f; x += 0.0625f) EXPECT_GE(atColumn(x, sun), 0.0f) << x;
  // Where the texels themselves are negative, so may be what lies between them.
  const auto negative = [](float) { return -2.0f; };
  EXPECT_NEAR(atColumn(4.3f, negative), -2.0f, 1e-5f);
}

TEST(Bicubic, IsBilinearWhereATexelIsMissing) {
  const auto fetch = [](int x, int y) { return glm::vec4(glm::vec3(static_cast<float>(x + y)), x < 5 ? 1.0f : 0.0f); };
  const glm::vec2 position(4.2f, 3.7f);
  EXPECT_EQ(bicubic(position, fetch), bilinear(position, fetch));
}

}  // namespace
}  // namespace mirrorball
