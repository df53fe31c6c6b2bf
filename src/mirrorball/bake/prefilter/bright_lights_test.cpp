#include "mirrorball/bake/prefilter/bright_lights.h"

#include <gtest/gtest.h>

#include "mirrorball/bake/prefilter/prefilter_testing.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

EnvironmentMap whitePanorama(int height) {
  return panoramaOf(2 * height, height, [](glm::vec3) { return glm::vec3(1.0f); });
}

TEST(BrightLights, AreThoseThatStandOut) {
  EnvironmentMap map = whitePanorama(32);
  EXPECT_TRUE(brightLights(map, 16).texels.empty());
  for (int i = 0; i < 20; ++i) map.face(0).texel(3 * i, 16)[2] = 1000.0f + static_cast<float>(i);
  const BrightLights few = brightLights(map, 16);
  ASSERT_EQ(few.texels.size(), 16u);
  ASSERT_EQ(few.points.size(), 16u);
  EXPECT_EQ(few.texels.front().texel, glm::ivec2(12, 16));
  EXPECT_NEAR(few.texels.back().radiance.z, 16.0f, 1e-2f) << "over the brightest of the rest, 1003";
  const BrightLights all = brightLights(map, 100);
  ASSERT_EQ(all.texels.size(), 20u);
  EXPECT_GT(all.texels.front().radiance.z, 800.0f) << "over eight times the mean";
}

TEST(BrightLights, SayWhetherAnyIsLeftOut) {
  EnvironmentMap map = whitePanorama(32);
  EXPECT_TRUE(brightLights(map, 16).is_complete);
  for (int i = 0; i < 20; ++i) map.face(0).texel(3 * i, 16)[2] = 1000.0f;
  EXPECT_FALSE(brightLights(map, 19).is_complete);
  EXPECT_TRUE(brightLights(map, 19).texels.empty()) << "all are alike";
  EXPECT_TRUE(brightLights(map, 20).is_complete);
}

TEST(BrightLights, StandOutFromTheMapWithoutThem) {
  EnvironmentMap map = whitePanorama(32);
  map.face(0).texel(20, 16)[0] = 1e6f;  // its mean is 500 times the rest
  map.face(0).texel(40, 16)[0] = 100.0f;
  EXPECT_EQ(brightLights(map, 16).texels.size(), 2u);
}

TEST(BrightLights, PointsHaveTheFluxOfTheirTexels) {
  EnvironmentMap map = whitePanorama(32);
  map.face(0).texel(10, 20)[0] = 5000.0f;
  const BrightLights lights = brightLights(map, 4);
  ASSERT_EQ(lights.points.size(), 1u);
  const float solid_angle = texelSolidAngle(Projection::equirect, {64, 32}, {10, 20});
  EXPECT_FLOAT_EQ(lights.points[0].flux.x, lights.texels[0].radiance.x * solid_angle);
  EXPECT_LT(glm::distance(lights.points[0].direction, directionAt(Projection::equirect, {0, {10.5f / 64, 20.5f / 32}})),
            1e-6f);
}

TEST(BrightLights, NarrowTexelsNearAPoleShareAPoint) {
  EnvironmentMap map = whitePanorama(256);
  float flux = 0.0f;
  for (int x = 0; x < 512; ++x) {
    map.face(0).texel(x, 0)[1] = 1e5f;
    flux += 1e5f * texelSolidAngle(Projection::equirect, {512, 256}, {x, 0});
  }
  const BrightLights lights = brightLights(map, 64);
  EXPECT_EQ(lights.texels.size(), 512u);
  EXPECT_LT(lights.points.size(), 64u);
  float found = 0.0f;
  for (const PointOfLight& point : lights.points) {
    EXPECT_NEAR(glm::length(point.direction), 1.0f, 1e-5f);
    found += point.flux.y;
  }
  EXPECT_NEAR(found, flux, 2e-3f * flux);
}

TEST(BrightLights, CanBeTakenOutOfTheirMap) {
  EnvironmentMap map = whitePanorama(32);
  for (const int x : {3, 4, 40}) map.face(0).texel(x, 9)[0] = 2000.0f;
  const BrightLights lights = brightLights(map, 16);
  ASSERT_EQ(lights.texels.size(), 3u);
  subtract(lights, map);
  EXPECT_TRUE(brightLights(map, 16).texels.size() < 3u || brightLights(map, 16).texels[0].radiance.x < 100.0f);
  EXPECT_GT(map.face(0).texel(3, 9)[0], 0.0f);
  EXPECT_FLOAT_EQ(map.face(0).texel(20, 9)[0], 1.0f);
}

}  // namespace
}  // namespace mirrorball
