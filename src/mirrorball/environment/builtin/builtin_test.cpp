#include "mirrorball/environment/builtin/builtin.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/sunset.h"
#include "mirrorball/environment/projection/direction_angles.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

TEST(BuiltinEnvironment, EveryNameGivesFiniteLightFromEverywhere) {
  for (const std::string_view name : builtinEnvironmentNames()) {
    const Environment environment = *builtinEnvironment(name);
    for (float elevation = -90.0f; elevation <= 90.0f; elevation += 5.0f)
      for (float azimuth = 0.0f; azimuth < 360.0f; azimuth += 5.0f) {
        const glm::vec3 light = environment.radiance(directionAtAngles(azimuth, elevation));
        EXPECT_TRUE(std::isfinite(light.x + light.y + light.z)) << name;
        EXPECT_GE(std::min({light.x, light.y, light.z}), 0.0f) << name;
      }
  }
}

TEST(BuiltinEnvironment, WhiteIsOne) { EXPECT_EQ(builtinEnvironment("white")->radiance({0, 1, 0}), glm::vec3(1.0f)); }

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
  EXPECT_THAT(builtinEnvironment("nebula").error().message,
              HasSubstr(hasSunset() ? "studio, sky, sunset, uv, white" : "studio, sky, uv, white"));
  EXPECT_THAT(builtinEnvironment("sky:elevatoin=3").error().message, HasSubstr("did you mean 'elevation'"));
  EXPECT_THAT(builtinEnvironment("sky:turbidity=1").error().message, HasSubstr("2 … 10"));
  EXPECT_THAT(builtinEnvironment("sky:turbidity").error().message, HasSubstr("turbidity"));
  EXPECT_THAT(builtinEnvironment("white:a=1").error().message, HasSubstr("takes no parameters"));
  EXPECT_FALSE(isBuiltinEnvironment("sky.hdr"));
}

}  // namespace
}  // namespace mirrorball
