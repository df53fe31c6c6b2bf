#include "mirrorball/light_edit/sun_split.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/light_edit/light_edit_testing.h"

namespace mirrorball {
namespace {

using testing::MadeSun;
using testing::mapOfSuns;
using ::testing::SizeIs;
using testing::smoothSky;

Environment skyWith(const std::vector<MadeSun>& suns) {
  return Environment(mapOfSuns(suns, smoothSky, Projection::equirect, 512));
}

TEST(SunSplit, ASunStandsApartWithItsSizeAndAllOfItsLight) {
  const MadeSun sun{{0.3f, 0.8f, -0.5f}, 1.8f, glm::vec3(3e4f, 2e4f, 1e4f)};
  const auto split = withoutSuns(skyWith({sun}));
  ASSERT_TRUE(split) << split.error().message;
  ASSERT_THAT(split->suns, SizeIs(1));
  EXPECT_NEAR(split->suns[0].radius, glm::radians(0.9f), glm::radians(0.05f));
  EXPECT_GT(glm::dot(split->suns[0].towards, glm::normalize(sun.direction)), 0.99999f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(split->suns[0].irradiance[c] / sun.irradiance()[c], 1.0f, 2e-3f);
  const glm::vec3 behind = split->rest.radiance(glm::normalize(sun.direction));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(behind[c] / smoothSky(glm::normalize(sun.direction))[c], 1.0f, 0.02f);
}

TEST(SunSplit, BothTogetherHaveTheLightOfTheMap) {
  const MadeSun sun{{0.0f, 0.2f, 1.0f}, 1.8f, glm::vec3(2e4f)};
  const Environment whole = skyWith({sun});
  const Environment again = withSuns(*withoutSuns(whole));
  EXPECT_EQ(again.map(), nullptr);
  EXPECT_GE(again.naturalSize(Projection::equirect), 512);
  const auto wholeOf = [](const Environment& environment) {
    return formula::luminance(wholeLight(*convert(environment, Projection::equirect, 1024)));
  };
  EXPECT_NEAR(wholeOf(again) / wholeOf(whole), 1.0f, 5e-3f);
  const glm::vec3 elsewhere = glm::normalize(glm::vec3(1.0f, 0.1f, 0.2f));
  EXPECT_EQ(again.radiance(elsewhere), whole.radiance(elsewhere));
  EXPECT_NEAR(again.radiance(glm::normalize(sun.direction)).x / 2e4f, 1.0f, 0.2f);
}

TEST(SunSplit, WhereThereIsNoneNothingChanges) {
  const Environment plain = skyWith({});
  const auto split = withoutSuns(plain);
  ASSERT_TRUE(split);
  EXPECT_TRUE(split->suns.empty());
  const glm::vec3 d = glm::normalize(glm::vec3(0.3f, 0.4f, 0.5f));
  EXPECT_EQ(split->rest.radiance(d), plain.radiance(d));
  EXPECT_EQ(withSuns(*split).radiance(d), plain.radiance(d));
}

TEST(SunSplit, OfManyTheStrongestStandApart) {
  std::vector<MadeSun> suns;
  for (int i = 0; i < 6; ++i)
    suns.push_back({{std::sin(float(i)), 0.4f, std::cos(float(i))}, 1.0f, glm::vec3(1e4f * float(i + 1))});
  const auto split = withoutSuns(skyWith(suns));
  ASSERT_TRUE(split);
  ASSERT_THAT(split->suns, SizeIs(kMostSuns));
  for (std::size_t i = 1; i < split->suns.size(); ++i)
    EXPECT_GE(split->suns[i - 1].irradiance.y, split->suns[i].irradiance.y);
}

TEST(SunSplit, WindowsDoNotCrowdItOut) {
  std::vector<MadeSun> lamps;
  for (int i = 0; i < 5; ++i)
    lamps.push_back({{std::sin(float(i)), 0.1f, std::cos(float(i))}, 8.0f, glm::vec3(200.0f)});
  lamps.push_back({{0.0f, 1.0f, 0.2f}, 1.0f, glm::vec3(1.2e4f)});
  const auto split = withoutSuns(skyWith(lamps));
  ASSERT_TRUE(split);
  ASSERT_THAT(split->suns, SizeIs(1));
  EXPECT_GT(split->suns[0].towards.y, 0.9f);
}

TEST(SunSplit, StrongIsASmallLampWithAFifthOfTheLight) {
  const auto isStrong = [](float size_deg, float share) {
    // The sky's light is about 4π.
    const MadeSun unit{{0.3f, 0.8f, -0.5f}, size_deg, glm::vec3(1.0f)};
    const float irradiance = 4.0f * 3.14159265f * share / (1.0f - share);
    return *hasStrongSun(skyWith({{unit.direction, size_deg, glm::vec3(irradiance / unit.solidAngle_sr())}}));
  };
  EXPECT_TRUE(isStrong(1.0f, 0.3f));
  EXPECT_FALSE(isStrong(1.0f, 0.1f));
  EXPECT_FALSE(isStrong(4.0f, 0.5f)) << "a window is no sun";
}

TEST(SunSplit, AStrongSunHasItsDirection) {
  const glm::vec3 direction = glm::normalize(glm::vec3(0.3f, 0.25f, -0.9f));
  const MadeSun unit{direction, 1.0f, glm::vec3(1.0f)};
  const auto sun = strongSun(skyWith({{direction, 1.0f, glm::vec3(6.0f / unit.solidAngle_sr())}}));
  ASSERT_TRUE(sun);
  ASSERT_TRUE(sun->has_value());
  EXPECT_GT(glm::dot(**sun, direction), std::cos(glm::radians(1.0f)));
  EXPECT_FALSE(strongSun(skyWith({}))->has_value());
}

}  // namespace
}  // namespace mirrorball
