#include "mirrorball/output/north_mark.h"

#include <algorithm>

#include <gtest/gtest.h>

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
