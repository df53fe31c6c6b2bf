#include "mirrorball/metric/picture/color_ramp.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "formula/color.h"

namespace mirrorball {
namespace {

/// Oklab's lightness of an encoded colour, the other way round than the ramps compute it (Ottosson 2020).
float lightnessOf(glm::vec3 encoded) {
  const glm::vec3 c = formula::linearFromSrgb(encoded);
  const float l = std::cbrt(0.4122214708f * c.x + 0.5363325363f * c.y + 0.0514459929f * c.z);
  const float m = std::cbrt(0.2119034982f * c.x + 0.6806995451f * c.y + 0.1073969566f * c.z);
  const float s = std::cbrt(0.0883024619f * c.x + 0.2817188376f * c.y + 0.6299787005f * c.z);
  return 0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s;
}

TEST(ColorRamp, SequentialLightnessGrowsEvenly) {
  for (int step = 0; step <= 255; ++step) {
    const float t = static_cast<float>(step) / 255.0f;
    EXPECT_NEAR(lightnessOf(sequentialColor(t)), 0.12f + 0.85f * t, 2e-3f) << t;
  }
}

TEST(ColorRamp, DivergingLightnessFallsEvenlyOnBothSides) {
  for (int step = 0; step <= 255; ++step) {
    const float t = static_cast<float>(step) / 255.0f;
    EXPECT_NEAR(lightnessOf(divergingColor(t)), 0.97f - 0.52f * t, 2e-3f) << t;
    EXPECT_NEAR(lightnessOf(divergingColor(-t)), 0.97f - 0.52f * t, 2e-3f) << t;
  }
  EXPECT_GT(divergingColor(1.0f).x, 2.0f * divergingColor(1.0f).z) << "red above";
  EXPECT_GT(divergingColor(-1.0f).z, 2.0f * divergingColor(-1.0f).x) << "blue below";
}

TEST(ColorRamp, EveryNumberHasAColourOfADisplay) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float t : {-infinity, -1e30f, -1.0f, -0.0f, 0.0f, 0.3f, 1.0f, 1.5f, infinity, std::nanf("")})
    for (const glm::vec3 color : {sequentialColor(t), divergingColor(t)}) {
      EXPECT_GE(std::min({color.x, color.y, color.z}), 0.0f) << t;
      EXPECT_LE(std::max({color.x, color.y, color.z}), 1.0f) << t;
    }
  EXPECT_EQ(sequentialColor(7.0f), sequentialColor(1.0f));
  EXPECT_EQ(divergingColor(-7.0f), divergingColor(-1.0f));
  EXPECT_EQ(divergingColor(std::nanf("")), divergingColor(0.0f));
}

}  // namespace
}  // namespace mirrorball
