#include "mirrorball/light_edit/lamp_split.h"

#include <cmath>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/light_edit/lamp_energy.h"
#include "mirrorball/light_edit/light_edit_testing.h"

namespace mirrorball {
namespace {

using testing::cloudySky;
using ::testing::IsEmpty;
using testing::kPlaces;
using testing::lampsIn;
using testing::MadeSky;
using testing::MadeSun;
using testing::mapOfSky;
using testing::mapOfSuns;
using ::testing::SizeIs;
using testing::smoothSky;

const float kMaxSize_rad = glm::radians(2.0f);

SplitMap splitOf(const EnvironmentMap& map) { return splitLamps(map, lampsIn(map), kMaxSize_rad); }

/// The largest relative difference of two maps.
float largestDifference(const EnvironmentMap& a, const EnvironmentMap& b) {
  float largest = 0.0f;
  for (int face = 0; face < a.faces(); ++face)
    for (std::size_t i = 0; i < a.face(face).samples().size(); ++i) {
      const float there = b.face(face).samples()[i];
      largest = std::max(largest, std::abs(a.face(face).samples()[i] - there) / there);
    }
  return largest;
}

TEST(LampSplit, LeavesTheSkyThatWasBehindASun) {
  for (const Projection projection : {Projection(Projection::equirect), Projection(Projection::cube)})
    for (const glm::vec3 place : kPlaces)
      for (const float size_deg : {0.2f, 0.53f, 1.0f}) {
        SCOPED_TRACE(std::string(nameOf(projection)) + ", " + std::to_string(size_deg) + " degrees at " +
                     std::to_string(place.x) + ", " + std::to_string(place.y) + ", " + std::to_string(place.z));
        const MadeSun sun{place, size_deg, glm::vec3(2e4f, 1.8e4f, 1.4e4f) / (size_deg * size_deg)};
        const SplitMap split = splitOf(mapOfSuns({sun}, smoothSky, projection, 256));
        ASSERT_THAT(split.taken, SizeIs(1));
        EXPECT_THAT(split.kept, IsEmpty());
        EXPECT_LT(largestDifference(split.rest, mapOfSky(smoothSky, projection, 256)), 0.01f);
        const glm::vec3 ratio = split.taken[0].lamp.irradiance / sun.irradiance();
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1.0f, 1e-3f);
      }
}

TEST(LampSplit, NoLightIsLostAndNoneIsNegative) {
  for (const MadeSky& sky : {MadeSky(smoothSky), MadeSky(cloudySky)}) {
    const EnvironmentMap map =
        mapOfSuns({{{0, 0.3f, 1}, 0.6f, {9e4f, 2e3f, 10.0f}}, {{0.03f, 0.3f, 1}, 0.4f, {0, 0, 5e4f}}}, sky,
                  Projection::equirect, 512);
    const SplitMap split = splitOf(map);
    ASSERT_THAT(split.taken, SizeIs(::testing::Ge(1u)));
    glm::dvec3 sum(wholeLight(split.rest));
    for (const TakenLamp& taken : split.taken) {
      sum += glm::dvec3(taken.lamp.irradiance);
      glm::dvec3 points(0.0);
      for (const PointOfLight& point : taken.light) {
        points += glm::dvec3(point.flux);
        EXPECT_GE(std::min({point.flux.x, point.flux.y, point.flux.z}), 0.0f);
      }
      EXPECT_LT(glm::length(points - glm::dvec3(taken.lamp.irradiance)), 1e-6 * glm::length(points));
    }
    EXPECT_LT(glm::length(sum - glm::dvec3(wholeLight(map))), 1e-6 * glm::length(sum));
    for (std::size_t i = 0; i < map.face(0).samples().size(); ++i) {
      EXPECT_GE(split.rest.face(0).samples()[i], 0.0f);
      EXPECT_LE(split.rest.face(0).samples()[i], map.face(0).samples()[i]);
    }
  }
}

TEST(LampSplit, TheGlowAroundASunIsFilledToo) {
  const MadeSun sun{{0.3f, 0.4f, 1}, 0.53f, glm::vec3(5e4f)};
  const glm::dvec3 middle = glm::normalize(glm::dvec3(sun.direction));
  const auto glowing = [&](glm::vec3 d) {
    return smoothSky(d) + glm::vec3(500.0f * float(std::exp(-angleBetween(d, middle) / 0.003)));
  };
  const SplitMap split = splitOf(mapOfSuns({sun}, glowing, Projection::equirect, 1024));
  ASSERT_THAT(split.taken, SizeIs(1));
  EXPECT_LT(largestSample(split.rest.face(0)), 6.0f) << "the sky is 1.4, the glow at the sun's rim 100";
}

TEST(LampSplit, WideLampsStayAndTheSettingSaysWhatIsWide) {
  const EnvironmentMap map = mapOfSuns({{{0, 0, 1}, 5.0f, glm::vec3(5e2f)}, {{1, 0, 0}, 0.5f, glm::vec3(1e4f)}},
                                       smoothSky, Projection::equirect, 512);
  const SplitMap split = splitOf(map);
  EXPECT_THAT(split.taken, SizeIs(1));
  ASSERT_THAT(split.kept, SizeIs(1));
  EXPECT_NEAR(glm::degrees(split.kept[0].angular_size_rad), 5.0f, 0.4f);
  EXPECT_THAT(splitLamps(map, lampsIn(map), glm::radians(6.0f)).taken, SizeIs(2));
  const SplitMap none = splitLamps(map, lampsIn(map), 0.0f);
  EXPECT_THAT(none.taken, IsEmpty());
  EXPECT_EQ(largestDifference(none.rest, map), 0.0f);
}

TEST(LampSplit, ALeafBeforeASunStaysDark) {
  const MadeSun sun{{0, 0.5f, 1}, 0.8f, glm::vec3(2e4f)};
  EnvironmentMap map = mapOfSuns({sun}, smoothSky, Projection::equirect, 1024);
  const MapPosition place = positionOf(Projection::equirect, glm::normalize(sun.direction));
  const glm::ivec2 leaf(place.uv * glm::vec2(map.extent()));
  std::fill_n(map.face(0).texel(leaf.x, leaf.y), 3, 0.01f);
  EXPECT_EQ(rgbAt(splitOf(map).rest.face(0), leaf.x, leaf.y), glm::vec3(0.01f));
}

/// Suns that light a surface more than all of the sky does.
TEST(LampEnergy, OfALampUpToOneDegreeIsThatOfTheMap) {
  for (const MadeSky& sky : {MadeSky(smoothSky), MadeSky(cloudySky)})
    for (const glm::vec3 place : kPlaces)
      for (const float size_deg : {0.2f, 0.53f, 1.0f}) {
        SCOPED_TRACE(std::to_string(size_deg) + " degrees at " + std::to_string(place.x) + ", " +
                     std::to_string(place.y));
        const MadeSun sun{place, size_deg, glm::vec3(7e4f, 6e4f, 5e4f) / (size_deg * size_deg) * 0.53f * 0.53f};
        const auto errors = lampErrors(splitOf(mapOfSuns({sun}, sky, Projection::equirect, 512)));
        ASSERT_TRUE(errors);
        ASSERT_THAT(*errors, SizeIs(1));
        EXPECT_LT((*errors)[0].irradiance, 0.002f);
        EXPECT_LT((*errors)[0].irradiance_of_point, 0.005f);
        EXPECT_LT((*errors)[0].rough_sphere, 0.02f);
      }
}

TEST(LampEnergy, OfAWideLampIsToldToBeOff) {
  const EnvironmentMap map = mapOfSuns({{{0, 0.5f, 1}, 12.0f, glm::vec3(2e3f)}}, smoothSky, Projection::equirect, 256);
  const auto errors = lampErrors(splitLamps(map, lampsIn(map), glm::radians(20.0f)));
  ASSERT_TRUE(errors);
  ASSERT_THAT(*errors, SizeIs(1));
  EXPECT_GT((*errors)[0].irradiance_of_point, 0.05f);
  EXPECT_LT((*errors)[0].irradiance, 0.02f) << "a disc of its size is what it was";
  EXPECT_GT((*errors)[0].rough_sphere, 0.1f);
}

TEST(LampEnergy, CanBeStoppedAndIsNoneOfNone) {
  const SplitMap split = splitOf(mapOfSuns({{{0, 0.5f, 1}, 1.0f}}, smoothSky, Projection::equirect, 256));
  const auto stopped = lampErrors(split, [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
  EXPECT_THAT(*lampErrors(splitOf(mapOfSky(smoothSky, Projection::equirect, 64))), IsEmpty());
}

TEST(LampEnergy, IsTheSameForAnyNumberOfThreads) {
  const EnvironmentMap map = mapOfSuns({{{0, 0.5f, 1}, 0.6f}, {{1, 0.5f, 0}, 0.9f}}, cloudySky, Projection::cube, 256);
  const SplitMap many = splitOf(map);
  ASSERT_THAT(many.taken, SizeIs(2));
  const auto errors = *lampErrors(many);
  const testing::OneThread one;
  const SplitMap few = splitOf(map);
  EXPECT_EQ(largestDifference(many.rest, few.rest), 0.0f);
  const auto again = *lampErrors(few);
  ASSERT_EQ(errors.size(), again.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    EXPECT_EQ(errors[i].irradiance, again[i].irradiance);
    EXPECT_EQ(errors[i].rough_sphere, again[i].rough_sphere);
  }
}

}  // namespace
}  // namespace mirrorball
