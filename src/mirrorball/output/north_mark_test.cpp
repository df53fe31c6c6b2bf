#include "mirrorball/output/north_mark.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

#include <gtest/gtest.h>

#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {
namespace {

EnvironmentMap evenPanorama(int height, float light) {
  ImageSet images(1, 1);
  images.at(0, 0) = Image(2 * height, height, 3, light);
  return {Projection::equirect, std::move(images)};
}

float lightAt(const EnvironmentMap& map, float degrees_right, float degrees_up) {
  const glm::ivec2 extent = map.extent();
  const int x = static_cast<int>((0.5f + degrees_right / 360.0f) * float(extent.x) + float(extent.x)) % extent.x;
  const int y = static_cast<int>((0.5f - degrees_up / 180.0f) * float(extent.y));
  return map.face(0).texel(x, y)[0];
}

// Also where the panorama's sides meet, and in any unit of light.
TEST(NorthMark, ALineAndALetterStandAtNorth) {
  for (const double heading : {0.0, 90.0, 180.0, 251.0})
    for (const float light : {0.01f, 1.0f, 1e5f}) {
      EnvironmentMap map = evenPanorama(1024, light);
      drawNorth(compassAxes({.heading_deg = heading}), map);
      const auto north = static_cast<float>(-heading);
      const float white = std::max(4.0f * light, 1.0f);
      EXPECT_NEAR(lightAt(map, north, 0.0f), white, 0.02f * white) << heading;
      EXPECT_NEAR(lightAt(map, north, -7.0f), white, 0.02f * white) << heading;
      EXPECT_NEAR(lightAt(map, north - 0.58f, 0.0f), 0.0f, 0.4f * light) << "a dark edge";
      EXPECT_EQ(lightAt(map, north + 1.2f, 0.0f), light);
      EXPECT_EQ(lightAt(map, north, 6.5f), light) << "between line and letter";
      // An N: its diagonal begins at the upper left. It is narrower by the cosine of its latitude on the sphere only.
      EXPECT_GT(lightAt(map, north - 2.6f, 9.0f), 2.0f * light);
      EXPECT_GT(lightAt(map, north + 2.6f, 9.0f), 2.0f * light);
      EXPECT_GT(lightAt(map, north - 1.3f, 13.0f), 2.0f * light);
      EXPECT_EQ(lightAt(map, north + 1.1f, 13.0f), light);
    }
}

TEST(NorthMark, AllElseStays) {
  EnvironmentMap map = evenPanorama(256, 0.5f);
  drawNorth(compassAxes({.heading_deg = 45.0}), map);
  std::size_t changed = 0;
  for (const float sample : map.face(0).samples()) changed += sample != 0.5f ? 1u : 0u;
  EXPECT_GT(changed, 300u);
  EXPECT_LT(changed, map.face(0).samples().size() / 100);
}

TEST(NorthMark, SmallAndBlackPanoramasHaveOne) {
  for (const int height : {1, 2, 16, 32}) {
    EnvironmentMap map = evenPanorama(height, 0.0f);
    drawNorth(compassAxes({}), map);
    const auto samples = map.face(0).samples();
    const float brightest = *std::max_element(samples.begin(), samples.end());
    EXPECT_LE(brightest, 1.0f);
    if (height >= 16) EXPECT_GT(brightest, 0.3f) << height;
  }
}

// A reach of 108 degrees in small panoramas, poles within the mark, and texels that the mean leaves out or counts as 0.
TEST(NorthMark, IsTheSameForAnyNumberOfThreads) {
  const int before = threadLimit();
  for (const int height : {64, 700})
    for (const double pitch : {0.0, 85.0}) {
      EnvironmentMap map = evenPanorama(height, 0.5f);
      const std::span<float> samples = map.face(0).samples();
      for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += 1e5f * float(i * i % 1009) / 3e4f;
      map.face(0).texel(height * 8 / 9, height / 2)[1] = std::numeric_limits<float>::quiet_NaN();
      map.face(0).texel(height * 8 / 9 + 2, height / 2)[0] = -1e6f;
      EnvironmentMap alone = map;
      setThreadLimit(1);
      drawNorth(compassAxes({.heading_deg = 20.0, .pitch_deg = pitch}), alone);
      setThreadLimit(4);
      drawNorth(compassAxes({.heading_deg = 20.0, .pitch_deg = pitch}), map);
      EXPECT_EQ(std::memcmp(samples.data(), alone.face(0).samples().data(), samples.size_bytes()), 0) << height;
    }
  setThreadLimit(before);
}

// What rejects a row or a texel by its cosine leaves out none that the mark reaches, also around the poles.
TEST(NorthMark, IsWholeHoweverThePictureIsTilted) {
  constexpr int kHeight = 512;
  const auto lightOnMark = [](const CompassHeading& heading) {
    EnvironmentMap map = evenPanorama(kHeight, 1.0f);
    drawNorth(compassAxes(heading), map);
    double light = 0.0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < 2 * kHeight; ++x)
        light += double(map.face(0).texel(x, y)[0] - 1.0f) * std::sin(glm::radians((y + 0.5) * 180.0 / kHeight));
    return light;
  };
  const double level = lightOnMark({});
  for (const double pitch : {-90.0, -80.0, 15.0, 72.0, 90.0})
    for (const double roll : {0.0, 50.0, 180.0})
      EXPECT_NEAR(lightOnMark({.heading_deg = 180.0, .pitch_deg = pitch, .roll_deg = roll}), level, 0.1 * level)
          << pitch;
}

// The mark reaches a fortieth of the sphere: drawing it costs less than two looks at the direction of every texel, of
// which the functions that give an angle alone would take more.
TEST(NorthMark, CostsNoMoreThanItsReach) {
  const auto seconds = [](const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  EnvironmentMap map = evenPanorama(2048, 0.5f);
  const glm::ivec2 extent = map.extent();
  glm::vec3 sum(0.0f);
  const double all = seconds([&] {
    for (int y = 0; y < extent.y; ++y)
      for (int x = 0; x < extent.x; ++x)
        sum += directionAt(Projection::equirect, {0, (glm::vec2(x, y) + 0.5f) / glm::vec2(extent)});
  });
  EXPECT_LT(glm::length(sum), 1e5f);
  EXPECT_LT(seconds([&] { drawNorth(compassAxes({.heading_deg = 45.0}), map); }), 2.0 * all);
}

// The mark leans as the horizon of a tilted picture does.
TEST(NorthMark, TheMarkStandsUprightInTheWorld) {
  EnvironmentMap map = evenPanorama(1024, 1.0f);
  const CompassAxes axes = compassAxes({.heading_deg = 0.0, .pitch_deg = 20.0, .roll_deg = 90.0});
  drawNorth(axes, map);
  for (const float up : {-4.0f, 3.0f}) {
    const float angle = glm::radians(up);
    const glm::vec3 direction = std::cos(angle) * axes.north + std::sin(angle) * axes.up;
    EXPECT_NEAR(map.radiance(direction).x, 4.0f, 0.1f) << up;
  }
}

}  // namespace
}  // namespace mirrorball
