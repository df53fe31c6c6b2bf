#include "mirrorball/view/map/prepared_map.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/constants.h"
#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/view/map/map_picture.h"
#include "mirrorball/view/map/map_testing.h"

namespace mirrorball {
namespace {

using testing::constantMap;
using ::testing::IsEmpty;
using testing::mapOf;
using ::testing::Not;
using testing::prepared;
using ::testing::SizeIs;

/// Whether every sample of every kind of light is a number.
bool allIsFinite(const PreparedMap& map) {
  for (int light = 0; light <= int(MapLight::harmonics); ++light)
    for (const MapPage page : {MapPage::all, MapPage::inside}) {
      MapViewSettings settings;
      settings.page = page;
      settings.light = static_cast<MapLight>(light);
      settings.waveform = settings.marks_lamps = settings.false_colors = true;
      const MapCanvas canvas{{160, 120}, 8};
      const Image shown = *mapLight(map, settings, canvas);
      if (findNonFinite(shown).count > 0) return false;
      mapPicture(map, shown, settings, canvas);
    }
  return true;
}

TEST(PreparedMap, TakesMapsOfEveryKindAndSize) {
  EXPECT_TRUE(allIsFinite(prepared(constantMap(Projection::equirect, 1, glm::vec3(2.0f)))));
  EXPECT_TRUE(allIsFinite(prepared(constantMap(Projection::cube, 1, glm::vec3(2.0f)))));
  EXPECT_TRUE(allIsFinite(prepared(constantMap(Projection::octahedral, 1, glm::vec3(2.0f)))));
  EXPECT_TRUE(allIsFinite(prepared(constantMap(Projection::hemioctahedral, 3, glm::vec3(2.0f)))));
  EXPECT_TRUE(allIsFinite(prepared(constantMap(Projection::eac, 5, glm::vec3(1e-30f)))));
  EXPECT_TRUE(allIsFinite(prepared(constantMap(Projection::equirect, 16, glm::vec3(1e30f)))));
}

TEST(PreparedMap, OfABlackMapIsBlack) {
  const PreparedMap map = prepared(constantMap(Projection::equirect, 16, glm::vec3(0.0f)));
  EXPECT_TRUE(allIsFinite(map));
  EXPECT_THAT(map.lamps, IsEmpty());
  EXPECT_EQ(map.faulty.count(), 0u);
  EXPECT_EQ(shownRadiance(map, {}, {0.0f, 1.0f, 0.0f}), glm::vec3(0.0f));
}

TEST(PreparedMap, CountsTexelsThatAreNoLightAndShowsTheRest) {
  EnvironmentMap map = constantMap(Projection::equirect, 32, glm::vec3(1.0f));
  map.face(0).texel(3, 4)[2] = NAN;
  map.face(0).texel(9, 30)[0] = INFINITY;
  map.face(0).texel(40, 8)[0] = -INFINITY;
  map.face(0).texel(41, 12)[1] = -0.5f;
  map.face(0).texel(60, 20)[1] = 1e37f;
  const PreparedMap found = prepared(map);
  EXPECT_EQ(found.faulty.not_finite, 3u);
  EXPECT_EQ(found.faulty.negative, 1u);
  EXPECT_EQ(found.faulty.too_bright, 1u);
  EXPECT_THAT(found.faulty.directions, SizeIs(5));
  EXPECT_TRUE(std::isnan(rgbAt(found.given->map()->face(0), 3, 4).z));
  EXPECT_EQ(rgbAt(found.mended->map()->face(0), 3, 4), glm::vec3(1.0f));
  EXPECT_EQ(rgbAt(found.mended->map()->face(0), 41, 12), glm::vec3(1.0f, 0.0f, 1.0f));
  EXPECT_TRUE(allIsFinite(found));
}

TEST(PreparedMap, OfMapsThatAreNoLightAtAllIsBlackAndMarksThemEverywhere) {
  for (const float bad : {NAN, -1.0f, -INFINITY}) {
    const PreparedMap map = prepared(constantMap(Projection::equirect, 128, glm::vec3(bad)));
    EXPECT_EQ(map.faulty.count(), 128u * 256u);
    // Most of the 64² parts of the sphere have a texel's centre in them.
    EXPECT_GT(map.faulty.directions.size(), 3500u);
    EXPECT_LE(map.faulty.directions.size(), 4096u);
    EXPECT_TRUE(allIsFinite(map));
    EXPECT_EQ(shownRadiance(map, {}, {0.0f, 1.0f, 0.0f}), glm::vec3(0.0f));
  }
}

TEST(PreparedMap, WhatLiesBesideADiscIsNoBadTexel) {
  ImageSet disc{Image(32, 32, 3, NAN)};
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      if (covers(Projection::sphere, (glm::vec2(x, y) + 0.5f) / 32.0f)) std::fill_n(disc.at(0, 0).texel(x, y), 3, 1.0f);
  EXPECT_EQ(prepared(EnvironmentMap(Projection::sphere, std::move(disc))).faulty.count(), 0u);
}

// As wide as 16 and 32 of the panorama's 512 rows, so that it can show both.
constexpr float kNarrow_rad = std::numbers::pi_v<float> / 32.0f;
constexpr float kWide_rad = std::numbers::pi_v<float> / 16.0f;

float solidAngleOf(float radius_rad) { return 4.0f * formula::kPi * std::pow(std::sin(radius_rad / 2.0f), 2.0f); }

/// Two discs, of radiance 200 and 50.
PreparedMap twoDiscs(Projection projection, int size, glm::vec3 first, glm::vec3 second) {
  return prepared(mapOf(projection, size, [&](glm::vec3 d) {
    if (glm::dot(d, first) > std::cos(kNarrow_rad)) return 200.0f;
    return glm::dot(d, second) > std::cos(kWide_rad) ? 50.0f : 0.1f;
  }));
}

TEST(Lamps, AreFoundWithTheirPlaceSizeAndLight) {
  // One of them lies on an edge of the cube, the other on a corner; then on a pole and on a panorama's seam.
  const glm::vec3 edge = glm::normalize(glm::vec3(1.0f, 0.05f, 1.0f));
  const glm::vec3 corner = glm::normalize(glm::vec3(-1.0f, 1.0f, -1.0f));
  const std::pair<glm::vec3, glm::vec3> places[] = {{edge, corner}, {{0, 1, 0}, {0, 0, -1}}};
  for (const auto& [first, second] : places)
    for (const PreparedMap& map :
         {twoDiscs(Projection::equirect, 512, first, second), twoDiscs(Projection::cube, 256, first, second)}) {
      ASSERT_THAT(map.lamps, SizeIs(2));
      const float angles[] = {solidAngleOf(kNarrow_rad), solidAngleOf(kWide_rad)};
      const float rest = 0.1f * (4.0f * formula::kPi - angles[0] - angles[1]);
      const float all = 200.0f * angles[0] + 50.0f * angles[1] + rest;
      // They shine alike, so that either may come first.
      const std::size_t narrow = map.lamps[0].radiance().x > 100.0f ? 0 : 1;
      const glm::vec3 directions[] = {first, second};
      const float radiances[] = {200.0f, 50.0f};
      for (std::size_t i = 0; i < 2; ++i) {
        const MapLamp& lamp = map.lamps[i == 0 ? narrow : 1 - narrow];
        EXPECT_GT(glm::dot(lamp.direction, directions[i]), 0.99999f);
        EXPECT_NEAR(lamp.solidAngle_sr() / angles[i], 1.0f, 0.03f);
        EXPECT_NEAR(lamp.radiance().x / radiances[i], 1.0f, 0.03f);
        EXPECT_NEAR(lamp.irradiance.x / (angles[i] * radiances[i]), 1.0f, 0.03f);
        EXPECT_NEAR(lamp.share, angles[i] * radiances[i] / all, 0.02f);
        EXPECT_NEAR(lamp.angular_size_rad / 2.0f, i == 0 ? kNarrow_rad : kWide_rad, 0.002f);
      }
    }
}

TEST(Lamps, OfEvenLightAreNone) {
  EXPECT_THAT(prepared(constantMap(Projection::equirect, 32, glm::vec3(3.0f))).lamps, IsEmpty());
  // Half of the sphere is the mean, however bright.
  const auto half = [](glm::vec3 d) { return d.y > 0.0f ? 100.0f : 0.1f; };
  EXPECT_THAT(prepared(mapOf(Projection::equirect, 64, half)).lamps, IsEmpty());
}

TEST(Lamps, ALampOfOneTexelKeepsItsLight) {
  const testing::Sun sun = testing::sunAt({100, 60}, 256, 1e5f);
  const PreparedMap map = prepared(sun.map);
  ASSERT_THAT(map.lamps, Not(IsEmpty()));
  EXPECT_GT(glm::dot(map.lamps[0].direction, sun.direction), 0.9999f);
  EXPECT_GT(map.lamps[0].share, 0.9f);
}

TEST(PreparedMap, TakesTheSmallestMipLevelThatIsEnough) {
  const PreparedMap map = prepared(constantMap(Projection::equirect, 512, glm::vec3(1.0f)));
  for (const float wanted : {1.0f, 7.0f, 30.0f, 100.0f}) {
    const auto parts = lightOf(map, {}, wanted);
    ASSERT_THAT(parts, SizeIs(1));
    EXPECT_GE(parts[0].light->texelDensity(), wanted);
    EXPECT_LT(parts[0].light->texelDensity(), 4.0f * wanted);
  }
  EXPECT_EQ(lightOf(map, {}, 1e9f)[0].light, map.mended);
}

TEST(PreparedMap, IsTheSameForAnyNumberOfThreads) {
  EnvironmentMap bad = testing::sunAt({100, 60}, 128, 1e5f).map;
  for (int x = 0; x < 256; x += 3) bad.face(0).texel(x, x / 2)[0] = NAN;
  const auto made = [&] {
    const PreparedMap map = prepared(bad);
    MapViewSettings settings;
    settings.waveform = settings.marks_lamps = true;
    return *MapViewer(map).picture(settings, {{400, 300}, 12});
  };
  const Image8 many = made();
  const testing::OneThread one;
  const Image8 few = made();
  EXPECT_TRUE(std::equal(many.samples().begin(), many.samples().end(), few.samples().begin()));
}

TEST(PreparedMap, CanBeStopped) {
  const auto stopped = prepareMap(Environment(constantMap(Projection::equirect, 256, glm::vec3(1.0f))), {},
                                  [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
