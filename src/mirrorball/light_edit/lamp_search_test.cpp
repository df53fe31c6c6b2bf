#include "mirrorball/light_edit/lamp_search.h"

#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/light_edit/light_edit_testing.h"

namespace mirrorball {
namespace {

using testing::cloudySky;
using ::testing::IsEmpty;
using testing::kPlaces;
using testing::lampsIn;
using testing::MadeSun;
using testing::mapOfSuns;
using ::testing::SizeIs;
using testing::smoothSky;

/// To how many degrees the size of a disc is found: the light of its rim is spread over a texel, and that of one no
/// larger than a texel over up to four.
float toleranceOfSize(float size_deg, float texel_deg) {
  return 0.02f * size_deg + (size_deg < 2.0f * texel_deg ? 2.0f : 0.55f) * texel_deg;
}

struct MapKind {
  Projection projection;
  int size;
  float texel_deg;
};
const MapKind kKinds[] = {
    {Projection::equirect, 512, 0.35f}, {Projection::cube, 256, 0.45f}, {Projection::eac, 256, 0.35f}};

TEST(LampSearch, FindsASunWhereverItIsAndHoweverLarge) {
  for (const MapKind& kind : kKinds)
    for (const glm::vec3 place : kPlaces)
      for (const float size_deg : {0.2f, 1.0f, 3.0f, 10.0f}) {
        SCOPED_TRACE(std::string(nameOf(kind.projection)) + ", " + std::to_string(size_deg) + " degrees at " +
                     std::to_string(place.x) + ", " + std::to_string(place.y) + ", " + std::to_string(place.z));
        // All shine as the sun at 0.53 degrees and 1e5.
        const float radiance = 1e5f * 0.28f / (size_deg * size_deg);
        const MadeSun sun{place, size_deg, glm::vec3(radiance)};
        const auto lamps = lampsIn(mapOfSuns({sun}, smoothSky, kind.projection, kind.size));
        ASSERT_THAT(lamps, SizeIs(1));
        EXPECT_LT(angleBetween(lamps[0].direction, glm::normalize(place)), glm::radians(0.3f * kind.texel_deg));
        EXPECT_NEAR(lamps[0].illuminance() / formula::luminance(sun.irradiance()), 1.0f, 0.03f);
        EXPECT_NEAR(glm::degrees(lamps[0].angular_size_rad), size_deg, toleranceOfSize(size_deg, kind.texel_deg));
        EXPECT_GE(glm::degrees(lamps[0].reach_rad()), size_deg / 2.0f);
        EXPECT_LT(glm::degrees(lamps[0].reach_rad()), size_deg / 2.0f + 2.0f * kind.texel_deg);
      }
}

TEST(LampSearch, AnOutlineGoesRoundItsLampOnce) {
  const MadeSun sun{{0.4f, 0.5f, 0.6f}, 6.0f, glm::vec3(1e3f)};
  const auto lamps = lampsIn(mapOfSuns({sun}, smoothSky, Projection::equirect, 512));
  ASSERT_THAT(lamps, SizeIs(1));
  const std::vector<glm::vec3>& outline = lamps[0].outline;
  ASSERT_GE(outline.size(), 8u);
  double turns = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec3 a(outline[i] - lamps[0].direction);
    const glm::dvec3 b(outline[(i + 1) % outline.size()] - lamps[0].direction);
    turns += std::atan2(glm::dot(glm::cross(a, b), glm::dvec3(lamps[0].direction)), glm::dot(a, b));
    EXPECT_NEAR(glm::degrees(angleBetween(outline[i], lamps[0].direction)), 3.0, 0.5);
  }
  EXPECT_NEAR(turns / (2.0 * 3.14159265), 1.0, 1e-2);
}

TEST(LampSearch, TellsTwoLampsApartAndTheirColours) {
  const MadeSun red{{0, 1, 1}, 1.0f, {4e3f, 1e2f, 0.0f}};
  const MadeSun blue{{0.1f, 1, 1}, 1.0f, {0.0f, 0.0f, 2e4f}};
  const auto lamps = lampsIn(mapOfSuns({red, blue}, cloudySky, Projection::equirect, 512));
  ASSERT_THAT(lamps, SizeIs(2));
  // The blue one is brighter, but for an eye it is not.
  EXPECT_NEAR(lamps[1].irradiance.x / red.irradiance().x, 1.0f, 0.05f);
  EXPECT_LT(lamps[1].irradiance.z / lamps[1].irradiance.x, 0.01f);
  EXPECT_NEAR(lamps[0].irradiance.z / blue.irradiance().z, 1.0f, 0.05f);
  EXPECT_GT(lamps[0].share, lamps[1].share);
}

TEST(LampSearch, PartsOfASunBehindLeavesAreOneLamp) {
  // Leaves hide stripes of it.
  const MadeSun sun{{0.2f, 0.7f, 0.6f}, 1.2f, glm::vec3(2e4f)};
  const glm::dvec3 middle = glm::normalize(glm::dvec3(sun.direction));
  const auto light = [&](glm::vec3 d) {
    if (std::sin(500.0f * d.x) > 0.3f) return glm::vec3(0.05f);
    return angleBetween(d, middle) < 0.0105 ? sun.radiance : smoothSky(d);
  };
  const auto lamps = lampsIn(testing::mapOfSky(light, Projection::equirect, 1024));
  ASSERT_THAT(lamps, SizeIs(1));
  EXPECT_LT(glm::degrees(lamps[0].angular_size_rad), 1.4f);
}

TEST(LampSearch, ASunInAWindowIsAnotherLampThanTheWindow) {
  const MadeSun sun{{0.1f, 0.2f, 1}, 0.6f, glm::vec3(1e5f)};
  const auto room = [](glm::vec3 d) {
    const bool is_window = d.z > 0.0f && std::abs(d.x) < 0.3f * d.z && std::abs(d.y) < 0.3f * d.z;
    return glm::vec3(is_window ? 20.0f : 0.2f);
  };
  const auto lamps = lampsIn(mapOfSuns({sun}, room, Projection::equirect, 512));
  ASSERT_THAT(lamps, SizeIs(2));
  EXPECT_LT(glm::degrees(lamps[0].angular_size_rad), 1.0f);
  EXPECT_GT(glm::degrees(lamps[1].angular_size_rad), 25.0f);
  EXPECT_THAT(lamps[1].outline, SizeIs(::testing::Ge(4u)));
}

TEST(LampSearch, EvenLightAndDarknessHaveNoLamps) {
  EXPECT_THAT(lampsIn(mapOfSuns({}, smoothSky, Projection::equirect, 64)), IsEmpty());
  EXPECT_THAT(lampsIn(mapOfSuns({}, cloudySky, Projection::cube, 64)), IsEmpty());
  EXPECT_THAT(lampsIn(mapOfSuns(
                  {}, [](glm::vec3) { return glm::vec3(0.0f); }, Projection::equirect, 64)),
              IsEmpty());
  // Half of the sphere is the mean, however bright.
  const auto half = [](glm::vec3 d) { return glm::vec3(d.y > 0.0f ? 100.0f : 0.1f); };
  EXPECT_THAT(lampsIn(mapOfSuns({}, half, Projection::equirect, 64)), IsEmpty());
  EXPECT_THAT(lampsIn(EnvironmentMap(Projection::equirect, ImageSet(Image(2, 1, 3, 1.0f)))), IsEmpty());
  EXPECT_THAT(lampsIn(testing::mapOfSuns({}, smoothSky, Projection::cube, 1)), IsEmpty());
}

TEST(LampSearch, OneLitTexelInDarknessIsALamp) {
  Image image(64, 32, 3);
  image.texel(20, 9)[1] = 1e30f;
  const auto lamps = lampsIn(EnvironmentMap(Projection::equirect, ImageSet(std::move(image))));
  ASSERT_THAT(lamps, SizeIs(1));
  EXPECT_NEAR(lamps[0].share, 1.0f, 1e-5f);
  EXPECT_TRUE(std::isfinite(lamps[0].illuminance()));
  EXPECT_FALSE(lamps[0].is_clipped);
  EXPECT_NEAR(glm::degrees(lamps[0].angular_size_rad), 5.6f, 1.5f);
}

TEST(LampSearch, WeakLampsAndTooManyAreLeftOut) {
  std::vector<MadeSun> suns;
  for (int i = 0; i < 6; ++i)
    suns.push_back({{std::cos(float(i)), 0.3f, std::sin(float(i))}, 1.0f, glm::vec3(1e3f * float(i + 1))});
  const EnvironmentMap map = mapOfSuns(suns, smoothSky, Projection::equirect, 256);
  const auto all = lampsIn(map, {.max = 100, .min_share = 0.001f});
  ASSERT_THAT(all, SizeIs(6));
  for (std::size_t i = 1; i < 6; ++i) EXPECT_GT(all[i - 1].illuminance(), all[i].illuminance());
  EXPECT_THAT(lampsIn(map, {.max = 2}), SizeIs(2));
  EXPECT_THAT(lampsIn(map, {.min_share = all[3].share}), SizeIs(4));
}

TEST(LampSearch, APlateauIsALowerBound) {
  EnvironmentMap map = mapOfSuns({{{0, 1, 1}, 2.0f, glm::vec3(1e5f)}}, smoothSky, Projection::equirect, 512);
  // No two texels of a real sun are alike.
  int number = 0;
  for (float& sample : map.face(0).samples()) sample *= 1.0f + 1e-5f * float(number++ % 997);
  EXPECT_FALSE(lampsIn(map)[0].is_clipped);
  // A camera's or a format's limit.
  for (float& sample : map.face(0).samples()) sample = std::min(sample, 200.0f);
  const auto clipped = lampsIn(map, {.min_share = 0.0f});
  ASSERT_THAT(clipped, SizeIs(1));
  EXPECT_TRUE(clipped[0].is_clipped);
}

TEST(LampSearch, IsTheSameForAnyNumberOfThreads) {
  const EnvironmentMap map = mapOfSuns({{{0, 1, 1}, 2.0f}, {{1, 1, 0}, 0.5f}}, cloudySky, Projection::cube, 128);
  const auto many = lampsIn(map);
  const testing::OneThread one;
  const auto few = lampsIn(map);
  ASSERT_EQ(many.size(), few.size());
  for (std::size_t i = 0; i < many.size(); ++i) {
    EXPECT_EQ(many[i].direction, few[i].direction);
    EXPECT_EQ(many[i].irradiance, few[i].irradiance);
    EXPECT_EQ(many[i].share, few[i].share);
    EXPECT_EQ(many[i].outline, few[i].outline);
  }
}

TEST(LampSearch, OtherProjectionsAreSearchedAsPanoramas) {
  for (const Projection projection : testing::kEveryProjection) {
    EnvironmentMap map = mapOfSuns({{{0.3f, 0.2f, 1}, 2.0f, glm::vec3(1e4f)}}, smoothSky, projection, 256);
    const EnvironmentMap searched = *searchedMap(Environment(std::move(map)));
    const auto lamps = lampsIn(searched);
    ASSERT_THAT(lamps, SizeIs(1)) << nameOf(projection);
    EXPECT_LT(angleBetween(lamps[0].direction, glm::normalize(glm::vec3(0.3f, 0.2f, 1))), glm::radians(0.2f));
  }
}

}  // namespace
}  // namespace mirrorball
