#include "mirrorball/environment/builtin.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

glm::vec3 directionOf(float azimuth_deg, float elevation_deg) {
  const float azimuth = glm::radians(azimuth_deg);
  const float elevation = glm::radians(elevation_deg);
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)};
}

TEST(BuiltinEnvironment, EveryNameGivesFiniteLightFromEverywhere) {
  for (const std::string_view name : builtinEnvironmentNames()) {
    const Environment environment = *builtinEnvironment(name);
    for (float elevation = -90.0f; elevation <= 90.0f; elevation += 5.0f)
      for (float azimuth = 0.0f; azimuth < 360.0f; azimuth += 5.0f) {
        const glm::vec3 light = environment.radiance(directionOf(azimuth, elevation));
        EXPECT_TRUE(std::isfinite(light.x + light.y + light.z)) << name;
        EXPECT_GE(std::min({light.x, light.y, light.z}), 0.0f) << name;
      }
  }
}

TEST(BuiltinEnvironment, WhiteIsOne) { EXPECT_EQ(builtinEnvironment("white")->radiance({0, 1, 0}), glm::vec3(1.0f)); }

TEST(BuiltinEnvironment, TheSunStandsWhereItIsPut) {
  const Environment sky = *builtinEnvironment("sky:elevation=20,azimuth=90");
  const float at_sun = formula::luminance(sky.radiance(directionOf(90, 20)));
  EXPECT_GT(at_sun, 1e4f);
  EXPECT_LT(formula::luminance(sky.radiance(directionOf(90, 22))), at_sun / 100.0f);
  const Environment without = *builtinEnvironment("sky:elevation=20,azimuth=90,sun=0");
  EXPECT_LT(formula::luminance(without.radiance(directionOf(90, 20))), 100.0f);
  // A clear sky is blue away from the sun.
  const glm::vec3 zenith = sky.radiance({0, 1, 0});
  EXPECT_GT(zenith.z, 1.3f * zenith.x);
}

// A mirror ball shows the ground behind the camera before the ground that is behind the ball. Where both are the same, its
// lower half vanishes.
TEST(BuiltinEnvironment, TheSkysGroundIsNeitherBlackNorAlike) {
  for (const char* elevation : {"2", "10", "45"}) {
    const Environment sky = *builtinEnvironment("sky:azimuth=0,elevation=" + std::string(elevation));
    const auto ground = [&](float azimuth, float below) {
      double sum = 0.0;
      for (float aside = -10.0f; aside <= 10.0f; aside += 0.5f)
        for (float deeper = 0.0f; deeper <= 4.0f; deeper += 0.5f)
          sum += double(formula::luminance(sky.radiance(directionOf(azimuth + aside, -below - deeper))));
      return sum / (41 * 9);
    };
    const double sky_at_horizon = double(formula::luminance(sky.radiance(directionOf(90, 2))));
    EXPECT_GT(ground(90, 25), 0.08 * sky_at_horizon) << elevation;
    // At 2° the sun gives less light than the sky.
    if (elevation != std::string("2")) {
      EXPECT_GT(ground(180, 25), 1.08 * ground(0, 25)) << "brighter with the sun behind one, at " << elevation;
    }
    EXPECT_LT(ground(90, 82), 0.95 * ground(90, 25)) << "what stands there keeps the sky away, at " << elevation;
    EXPECT_NEAR(formula::luminance(sky.radiance(directionOf(90, -0.01f))),
                formula::luminance(sky.radiance(directionOf(90, 0.01f))), 0.05 * sky_at_horizon)
        << "no edge at the horizon";
  }
}

// The built-in cube, whose sides are at ±1/√3: in the middle of each of the three that are seen.
TEST(BuiltinEnvironment, TheSidesOfAMirrorCubeStandOutInTheStudio) {
  const Environment studio = *builtinEnvironment("studio");
  const glm::vec3 camera = 3.0f * directionOf(30, 25);
  for (const glm::vec3 normal : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
    const glm::vec3 ray = glm::normalize(normal / std::sqrt(3.0f) - camera);
    const float behind = formula::luminance(studio.radiance(ray));
    EXPECT_GT(formula::luminance(studio.radiance(glm::reflect(ray, normal))), 1.5f * behind) << normal.x << normal.y;
  }
}

TEST(BuiltinEnvironment, TheUvFacesHaveTheirColours) {
  const Environment uv = *builtinEnvironment("uv");
  // Off the centre, where the letters are not.
  const auto near = [&](glm::vec3 axis, glm::vec3 aside) { return uv.radiance(glm::normalize(axis + 0.85f * aside)); };
  EXPECT_GT(near({1, 0, 0}, {0, -1, 0}).x, 2.0f * near({1, 0, 0}, {0, -1, 0}).y) << "+X is red";
  EXPECT_GT(near({0, 1, 0}, {1, 0, 0}).y, 2.0f * near({0, 1, 0}, {1, 0, 0}).x) << "+Y is green";
  EXPECT_GT(near({0, 0, 1}, {0, -1, 0}).z, 2.0f * near({0, 0, 1}, {0, -1, 0}).x) << "+Z is blue";
}

// The sign stands left of the letter for a reader who looks along the axis with +Y up: looking along +Z, left is +X.
TEST(BuiltinEnvironment, TheUvLabelsReadNormally) {
  const Environment uv = *builtinEnvironment("uv");
  const auto is_white = [&](glm::vec3 d) { return uv.radiance(glm::normalize(d)) == glm::vec3(0.95f); };
  EXPECT_TRUE(is_white({0.34f, 0.2f, 1.0f})) << "the upright of the plus sign";
  EXPECT_FALSE(is_white({-0.34f, 0.2f, 1.0f})) << "beside the Z's diagonal";
  EXPECT_TRUE(is_white({-0.30f, 0.0f, 1.0f})) << "the middle of the Z";
  EXPECT_TRUE(is_white({-0.30f - 0.28f, 0.28f, 1.0f})) << "the Z's stroke goes up to the reader's right, which is -X";
  EXPECT_FALSE(is_white({-0.30f + 0.18f, 0.18f, 1.0f}));
}

TEST(BuiltinEnvironment, WrongNamesAndParametersAreTold) {
  EXPECT_THAT(builtinEnvironment("nebula").error().message, HasSubstr("studio, sky, uv, white"));
  EXPECT_THAT(builtinEnvironment("sky:elevatoin=3").error().message, HasSubstr("did you mean 'elevation'"));
  EXPECT_THAT(builtinEnvironment("sky:turbidity=1").error().message, HasSubstr("2 … 10"));
  EXPECT_THAT(builtinEnvironment("sky:turbidity").error().message, HasSubstr("turbidity"));
  EXPECT_THAT(builtinEnvironment("white:a=1").error().message, HasSubstr("takes no parameters"));
  EXPECT_FALSE(isBuiltinEnvironment("sky.hdr"));
}

}  // namespace
}  // namespace mirrorball
