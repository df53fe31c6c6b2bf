#include "mirrorball/environment/file/light_limits.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

EnvironmentMap grey(Projection projection, int size, float light) {
  return *convert(Environment([light](glm::vec3) { return glm::vec3(light); }, 1), projection, size);
}

TEST(LightLimits, ABrightTexelIsLoweredAndKeepsItsHue) {
  EnvironmentMap map = grey(Projection::equirect, 16, 1.0f);
  float* sun = map.face(0).texel(3, 5);
  sun[0] = 400.0f;
  sun[1] = 200.0f;
  sun[2] = 100.0f;
  limitLight(map, {.max = 10.0f});
  EXPECT_EQ(rgbAt(map.face(0), 3, 5), glm::vec3(10.0f, 5.0f, 2.5f));
  EXPECT_EQ(rgbAt(map.face(0), 4, 5), glm::vec3(1.0f));
}

TEST(LightLimits, WhatIsLostIsToldBySolidAngle) {
  for (const Projection projection : {Projection::equirect, Projection::cube, Projection::octahedral}) {
    EnvironmentMap map = grey(projection, 700, 1.0f);
    std::fill_n(map.face(0).texel(93, 210), 3, 1e5f);
    std::fill_n(map.face(0).texel(94, 210), 3, 99.0f);
    const double before = testing::fluxOf(map);
    const LostLight light = limitLight(map, {.max = 100.0f});
    EXPECT_NEAR(light.share(), 1.0 - testing::fluxOf(map) / before, 0.02 * light.share()) << nameOf(projection);
    EXPECT_GT(light.share(), 0.01) << nameOf(projection);
  }
}

TEST(LightLimits, AScaleComesBeforeTheLimit) {
  EnvironmentMap map = grey(Projection::cube, 8, 3.0f);
  EXPECT_EQ(limitLight(map, {.scale = 0.5f, .max = 2.0f}).lost, 0.0);
  EXPECT_EQ(rgbAt(map.face(2), 1, 1), glm::vec3(1.5f));
}

TEST(LightLimits, AFunctionIsScaledAndLimitedToo) {
  Environment sky([](glm::vec3 d) { return d.y > 0.9f ? glm::vec3(50.0f, 25.0f, 0.0f) : glm::vec3(1.0f); }, 64);
  limitLight(sky, {.scale = 2.0f, .max = 10.0f});
  EXPECT_EQ(sky.radiance({0.0f, 1.0f, 0.0f}), glm::vec3(10.0f, 5.0f, 0.0f));
  EXPECT_EQ(sky.radiance({0.0f, 0.0f, 1.0f}), glm::vec3(2.0f));
  EXPECT_EQ(sky.naturalSize(Projection::equirect), 64);
}

TEST(LightLimits, ExtremeLight) {
  EnvironmentMap map = grey(Projection::equirect, 1, 1.0f);
  std::fill_n(map.face(0).texel(0, 0), 3, 3e38f);
  map.face(0).texel(1, 0)[0] = std::numeric_limits<float>::quiet_NaN();
  const LostLight light = limitLight(map, {.max = 65504.0f});
  EXPECT_EQ(rgbAt(map.face(0), 0, 0).x, 65504.0f);
  EXPECT_TRUE(std::isnan(map.face(0).texel(1, 0)[0]));
  EXPECT_NEAR(light.share(), 1.0, 1e-6);
}

}  // namespace
}  // namespace mirrorball
