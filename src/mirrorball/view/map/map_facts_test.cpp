#include "mirrorball/view/map/map_facts.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/view/map/map_testing.h"

namespace mirrorball {
namespace {

using testing::constantMap;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::prepared;
using testing::settingsOf;

const MapCanvas kFactsCanvas{{512, 256}, 16};

std::string factNamed(const std::vector<MapFact>& facts, std::string_view name) {
  for (const MapFact& fact : facts)
    if (fact.name == name) return fact.value;
  return "nothing";
}

TEST(MapFacts, AreTheStepsOfTheLecturesExample) {
  const PreparedMap map = *prepareMap(*builtinEnvironment("uv"));
  const glm::vec3 direction = glm::normalize(glm::vec3(-0.84f, 0.23f, 0.49f));
  MapViewSettings settings;
  settings.page = MapPage::inside;
  settings.yaw_deg = -30.0f;
  const auto facts = mapFactsAt(map, settings, kFactsCanvas, pixelsOf(settings, kFactsCanvas, direction).at(0));
  EXPECT_EQ(factNamed(facts, "longest component"), "x = -0.8406");
  EXPECT_EQ(factNamed(facts, "face"), "-X");
  EXPECT_EQ(factNamed(facts, "sc, tc, ma"), "0.4903 -0.2302 0.8406");
  EXPECT_EQ(factNamed(facts, "s, t"), "0.7917 0.3631");
  EXPECT_EQ(factNamed(facts, "cube's texel"), "405, 185 of 512x512") << "as `info` says";
  EXPECT_EQ(factNamed(facts, "longitude"), "-59.74");
  EXPECT_EQ(factNamed(facts, "latitude"), "13.31");
  EXPECT_EQ(factNamed(facts, "radiance"), "0.05 0.6 0.62");
}

TEST(MapFacts, TellTheTexelUnderThePointer) {
  EnvironmentMap panorama = constantMap(Projection::equirect, 8, glm::vec3(1.0f));
  const glm::vec3 light(0.1f, 65504.0f, 1e5f);
  std::copy_n(&light.x, 3, panorama.face(0).texel(11, 2));
  const PreparedMap map = prepared(std::move(panorama));
  // A texel is 32 pixels wide.
  const auto facts = mapFactsAt(map, settingsOf(Projection::equirect), kFactsCanvas, {11.5f * 32.0f, 2.5f * 32.0f});
  EXPECT_EQ(factNamed(facts, "projection"), "equirect");
  EXPECT_EQ(factNamed(facts, "u, v"), "0.7188 0.3125");
  EXPECT_EQ(factNamed(facts, "map's texel"), "11, 2 of 16x8");
  EXPECT_EQ(factNamed(facts, "radiance"), "0.1 65504 1e+05");
  EXPECT_EQ(factNamed(facts, "16-bit"), "0x2e66 0x7bff 0x7c00");
  EXPECT_EQ(factNamed(facts, "16-bit value"), "0.099976 65504 inf");
  EXPECT_EQ(factNamed(facts, "luminance"), "54068");
  EXPECT_EQ(factNamed(facts, "stops above 1"), "15.722");
  EXPECT_EQ(factNamed(facts, "bad"), "no");
  EXPECT_EQ(factNamed(facts, "shown radiance"), "nothing");
}

TEST(MapFacts, SayWhatIsWrongWithATexel) {
  EnvironmentMap panorama = constantMap(Projection::equirect, 8, glm::vec3(1.0f));
  panorama.face(0).texel(0, 0)[0] = NAN;
  panorama.face(0).texel(1, 0)[0] = -2.0f;
  const PreparedMap map = prepared(std::move(panorama));
  const auto badAt = [&](float x) {
    return factNamed(mapFactsAt(map, settingsOf(Projection::equirect), kFactsCanvas, {x, 5.0f}), "bad");
  };
  EXPECT_EQ(badAt(5.0f), "NaN or infinite");
  EXPECT_EQ(badAt(40.0f), "negative");
  EXPECT_EQ(badAt(70.0f), "no");
  const auto facts = mapFacts(map, {});
  EXPECT_EQ(factNamed(facts, "bad texels"), "2");
  EXPECT_EQ(factNamed(facts, "negative"), "1");
}

TEST(MapFacts, TellWhichImageOfAMapIsUnderThePointer) {
  const PreparedMap map = prepared(constantMap(Projection::cube, 8, glm::vec3(1.0f)));
  const MapViewSettings settings = settingsOf(Projection::cube);
  const auto facts =
      mapFactsAt(map, settings, kFactsCanvas, pixelsOf(settings, kFactsCanvas, glm::vec3(0.0f, -1.0f, 0.0f)).at(0));
  EXPECT_EQ(factNamed(facts, "projection"), "cube, face -Y");
  EXPECT_THAT(factNamed(facts, "map's texel"), HasSubstr("face -Y"));
  EXPECT_THAT(mapFactsAt(map, settings, kFactsCanvas, {0.0f, 0.0f}), IsEmpty()) << "a corner beside the cross";
  const PreparedMap half = prepared(constantMap(Projection::hemioctahedral, 8, glm::vec3(1.0f)));
  const MapViewSettings panorama = settingsOf(Projection::equirect);
  EXPECT_EQ(factNamed(mapFactsAt(half, panorama, kFactsCanvas, {2.0f, 128.0f}), "map's texel"), "not in the map");
}

TEST(MapFacts, TellWhatIsShownWhereItIsNotTheMap) {
  const PreparedMap map = prepared(constantMap(Projection::equirect, 32, glm::vec3(0.25f)));
  MapViewSettings settings = settingsOf(Projection::sphere);
  settings.light = MapLight::irradiance;
  const auto facts = mapFactsAt(map, settings, kFactsCanvas, {256.0f, 128.0f});
  EXPECT_EQ(factNamed(facts, "shown stops above 1").substr(0, 2), "-2");
}

TEST(MapFacts, TellLampsAndHarmonics) {
  const PreparedMap map = prepared(constantMap(Projection::equirect, 32, glm::vec3(1.0f)));
  MapViewSettings settings;
  settings.degree = 0;
  // √(4π)
  EXPECT_THAT(factNamed(mapFacts(map, settings), "harmonic"), HasSubstr("0, 0: 3.5449"));
  EXPECT_EQ(factNamed(mapFacts(map, settings), "lamp"), "nothing");
  const PreparedMap sunny = prepared(testing::sunAt({60, 20}, 64, 1e5f).map);
  EXPECT_THAT(factNamed(mapFacts(sunny, settings), "lamp"), HasSubstr("% of the light"));
}

}  // namespace
}  // namespace mirrorball
