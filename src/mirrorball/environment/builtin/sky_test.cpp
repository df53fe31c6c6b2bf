#include "mirrorball/environment/builtin/sky.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "formula/color.h"
#include "formula/constants.h"
#include "mirrorball/environment/builtin/sky_light.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/projection/direction_angles.h"

namespace mirrorball {
namespace {

using testing::manyDirections;

SkyLight skyLight(float elevation_deg, float turbidity = SkyParameters{}.turbidity) {
  return SkyLight(directionAtAngles(0, elevation_deg), turbidity);
}

/// Of a level surface, by the sky without the sun, in klx.
float levelIrradiance(const SkyLight& light) {
  float sum = 0.0f;
  for (const glm::vec3& d : manyDirections(4000))
    if (d.y > 0.0f) sum += formula::luminance(light.radiance(d)) * d.y * (4.0f * formula::kPi / 4000.0f);
  return sum;
}

// Clear skies as they were measured: the luminance of the zenith, 0.3 + 3 tan γ kcd/m² (Kittler 1967, the CIE's
// standard sky), and the light on level ground, of the sun 127.5 sin γ exp(−0.21 / sin γ) and of the sky 0.8 + 15.5
// √(sin γ) klx (IES's recommended practice for daylight, RP-21).
TEST(SkyLight, IsAsBrightAsMeasured) {
  for (const float elevation : {10.0f, 20.0f, 30.0f, 45.0f, 60.0f}) {
    const SkyLight light = skyLight(elevation, 2.0f);
    const float sine = std::sin(glm::radians(elevation));
    const float zenith_kcd = 0.3f + 3.0f * std::tan(glm::radians(elevation));
    const float sun_klx = 127.5f * std::exp(-0.21f / sine) * sine;
    const float sky_klx = 0.8f + 15.5f * std::sqrt(sine);
    EXPECT_NEAR(formula::luminance(light.radiance({0, 1, 0})) / zenith_kcd, 1.0f, 0.16f) << elevation;
    EXPECT_NEAR(formula::luminance(light.sunIrradiance()) * sine / sun_klx, 1.0f, 0.05f) << elevation;
    EXPECT_NEAR(levelIrradiance(light) / sky_klx, 1.0f, 0.18f) << elevation;
  }
}

TEST(SkyLight, IsSmooth) {
  const SkyLight light = skyLight(10);
  for (float azimuth = 0.0f; azimuth < 180.0f; azimuth += 15.0f)
    for (float elevation = 0.0f; elevation < 89.0f; elevation += 0.5f) {
      const float here = formula::luminance(light.radiance(directionAtAngles(azimuth, elevation)));
      const float above = formula::luminance(light.radiance(directionAtAngles(azimuth, elevation + 0.5f)));
      EXPECT_NEAR(above / here, 1.0f, 0.12f) << azimuth << ", " << elevation;
    }
  const glm::vec3 east = light.radiance(directionAtAngles(70, 20));
  const glm::vec3 west = light.radiance(directionAtAngles(-70, 20));
  EXPECT_LT(glm::length(east - west), 1e-4f * glm::length(east)) << "alike on both sides of the sun";
}

TEST(SkyLight, TheNoonSkyIsBlueAndItsHorizonWhitish) {
  for (const float elevation : {30.0f, 45.0f, 70.0f, 90.0f}) {
    const SkyLight light = skyLight(elevation);
    const glm::vec3 high = light.radiance(directionAtAngles(180, 40));
    EXPECT_GT(high.z, 1.5f * high.x) << elevation;
    EXPECT_GT(high.y, 1.1f * high.x) << elevation;
    for (const float azimuth : {90.0f, 135.0f, 180.0f})
      for (const float above : {0.0f, 2.0f, 5.0f}) {
        // The model before this one, Preetham's, was mauve: red above green.
        const glm::vec3 horizon = light.radiance(directionAtAngles(azimuth, above));
        EXPECT_GT(horizon.y, horizon.x) << elevation << ": " << azimuth << ", " << above;
        EXPECT_GT(horizon.z, horizon.y) << elevation << ": " << azimuth << ", " << above;
        EXPECT_LT(horizon.z / horizon.x, high.z / high.x) << elevation << ": " << azimuth << ", " << above;
        EXPECT_GT(horizon.y, high.y) << elevation << ": " << azimuth << ", " << above;
      }
  }
}

TEST(SkyLight, SunsetsAreWarmTowardsTheSunAndBlueAwayFromIt) {
  for (const float elevation : {1.0f, 2.0f, 5.0f}) {
    const SkyLight light = skyLight(elevation);
    const glm::vec3 near_sun = light.radiance(directionAtAngles(6, 3));
    EXPECT_GT(near_sun.x, 1.3f * near_sun.y) << elevation;
    EXPECT_GT(near_sun.y, 1.3f * near_sun.z) << elevation;
    const glm::vec3 opposite = light.radiance(directionAtAngles(180, 15));
    EXPECT_GT(opposite.z, 1.2f * opposite.x) << elevation;
    EXPECT_GT(formula::luminance(near_sun), 2.0f * formula::luminance(opposite)) << elevation;
    EXPECT_GT(light.sunIrradiance().x, 2.0f * light.sunIrradiance().y) << "the sun itself is red";
  }
}

TEST(Sky, TheExposureFollowsTheLight) {
  const auto zenith = [](float elevation_deg, float adaptation) {
    const Environment sky = skyEnvironment({.elevation_deg = elevation_deg, .adaptation = adaptation});
    return formula::luminance(sky.radiance({0, 1, 0}));
  };
  EXPECT_NEAR(zenith(45, 0) * 20.0f, formula::luminance(skyLight(45).radiance({0, 1, 0})), 1e-3f) << "kcd/m²";
  EXPECT_GT(zenith(2, 0.7f), 0.1f) << "Preetham's, at 20 kcd/m², had 0.1";
  EXPECT_GT(zenith(2, 0.7f), 5.0f * zenith(2, 0));
  EXPECT_LT(zenith(2, 0.7f), zenith(10, 0.7f) * 1.2f) << "and is still an evening's";
}

TEST(Sky, TheSunStandsWhereItIsPut) {
  const Environment sky = skyEnvironment({.elevation_deg = 20, .azimuth_deg = 90});
  const float at_sun = formula::luminance(sky.radiance(directionAtAngles(90, 20)));
  EXPECT_GT(at_sun, 1e4f);
  EXPECT_LT(formula::luminance(sky.radiance(directionAtAngles(90, 22))), at_sun / 100.0f);
  const Environment without = skyEnvironment({.elevation_deg = 20, .azimuth_deg = 90, .sun = 0});
  EXPECT_LT(formula::luminance(without.radiance(directionAtAngles(90, 20))), 100.0f);
}

// A mirror ball shows the ground behind the camera before the ground that is behind the ball. Where both are the same,
// its lower half vanishes.
TEST(Sky, TheGroundIsNeitherBlackNorAlike) {
  for (const float elevation : {2.0f, 10.0f, 45.0f}) {
    const Environment sky = skyEnvironment({.elevation_deg = elevation, .azimuth_deg = 0});
    const auto ground = [&](float azimuth, float below) {
      double sum = 0.0;
      for (float aside = -10.0f; aside <= 10.0f; aside += 0.5f)
        for (float deeper = 0.0f; deeper <= 4.0f; deeper += 0.5f)
          sum += double(formula::luminance(sky.radiance(directionAtAngles(azimuth + aside, -below - deeper))));
      return sum / (41 * 9);
    };
    const double sky_at_horizon = double(formula::luminance(sky.radiance(directionAtAngles(90, 2))));
    EXPECT_GT(ground(90, 25), 0.08 * sky_at_horizon) << elevation;
    // At 2° the sun gives less light than the sky.
    if (elevation > 2.0f) {
      EXPECT_GT(ground(180, 25), 1.08 * ground(0, 25)) << "brighter with the sun behind one, at " << elevation;
    }
    EXPECT_LT(ground(90, 82), 0.95 * ground(90, 25)) << "what stands there keeps the sky away, at " << elevation;
    EXPECT_NEAR(formula::luminance(sky.radiance(directionAtAngles(90, -0.01f))),
                formula::luminance(sky.radiance(directionAtAngles(90, 0.01f))), 0.05 * sky_at_horizon)
        << "no edge at the horizon";
  }
}

}  // namespace
}  // namespace mirrorball
