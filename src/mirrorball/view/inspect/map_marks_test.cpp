#include "mirrorball/view/inspect/map_marks.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/environment/cube/cube_layout.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/rays/frame.h"

namespace mirrorball {
namespace {

/// A picture with one bright texel, at that place.
Image brightAt(glm::vec2 place, glm::ivec2 size) {
  Image picture(size.x, size.y, 3);
  const glm::ivec2 texel = glm::min(glm::ivec2(place * glm::vec2(size)), size - 1);
  std::fill_n(picture.texel(texel.x, texel.y), 3, 1.0f);
  return picture;
}

ImageSet setOf(Image image) {
  ImageSet images(1, 1);
  images.at(0, 0) = std::move(image);
  return images;
}

/// Directions at an angle around another one.
std::vector<glm::vec3> circleAround(glm::vec3 direction, float angle_deg, int count = 64) {
  const Frame frame(direction);
  const float angle = glm::radians(angle_deg);
  std::vector<glm::vec3> circle;
  for (int i = 0; i < count; ++i) {
    const float around = 6.2831853f * float(i) / float(count);
    circle.push_back(std::cos(angle) * frame.n +
                     std::sin(angle) * (std::cos(around) * frame.t + std::sin(around) * frame.b));
  }
  return circle;
}

// A direction lies between at most four texels, of which the one that holds its place counts at least a quarter.
TEST(MapMarks, AMapThatIsBrightAtTheDotIsBrightInTheDirection) {
  constexpr int kSide = 32;
  constexpr float kLeast = 0.2f;
  for (const glm::vec3 direction : testing::manyDirections(500)) {
    const MapMarks marks = marksOf(direction, {});
    const EnvironmentMap panorama(Projection::equirect, setOf(brightAt(marks.panorama.dot, {2 * kSide, kSide})));
    EXPECT_GT(panorama.radiance(direction).x, kLeast);
    const Image cross = brightAt(marks.cross.dot, {4 * kSide, 3 * kSide});
    const EnvironmentMap cube(Projection::cube, *splitLayout(cross, CubeLayout::hcross));
    EXPECT_GT(cube.radiance(direction).x, kLeast);
    if (testing::isEnd(Projection::sphere, direction)) continue;
    const EnvironmentMap sphere(Projection::sphere, setOf(brightAt(marks.sphere_map.dot, {kSide, kSide})));
    EXPECT_GT(sphere.radiance(direction).x, kLeast);
  }
}

TEST(MapMarks, TheMiddleOfAMapIsPlusZ) {
  const MapMarks marks = marksOf({0, 0, 1}, {});
  EXPECT_LT(glm::distance(marks.panorama.dot, glm::vec2(0.5f)), 1e-6f);
  EXPECT_LT(glm::distance(marks.cross.dot, glm::vec2(1.5f / 4.0f, 0.5f)), 1e-6f);
  EXPECT_LT(glm::distance(marks.sphere_map.dot, glm::vec2(0.5f)), 1e-6f);
  EXPECT_TRUE(marks.panorama.outline.empty());
}

TEST(MapMarks, AnOutlineAwayFromSeamsIsOneClosedLine) {
  const MapMarks marks = marksOf({0, 0, 1}, circleAround({0, 0, 1}, 30.0f));
  for (const MapMark* mark : {&marks.panorama, &marks.cross, &marks.sphere_map}) {
    ASSERT_EQ(mark->outline.size(), 1u);
    EXPECT_EQ(mark->outline[0].front(), mark->outline[0].back());
    for (const glm::vec2 place : mark->outline[0]) EXPECT_GT(glm::distance(place, mark->dot), 0.05f);
  }
}

TEST(MapMarks, ALineEndsAtASeamAndGoesOnBeyond) {
  const std::vector<glm::vec3> circle = circleAround({0, 0, -1}, 20.0f, 51);  // none of which is on the seam
  const MapMarks marks = marksOf({0, 0, -1}, circle);
  // It crosses the panorama's edge twice, and begins between; in the cross it stays on −Z.
  EXPECT_EQ(marks.panorama.outline.size(), 3u);
  EXPECT_EQ(marks.cross.outline.size(), 1u);
  float leftmost = 1.0f, rightmost = 0.0f;
  for (const auto& line : marks.panorama.outline)
    for (const glm::vec2 place : line) {
      leftmost = std::min(leftmost, place.x);
      rightmost = std::max(rightmost, place.x);
    }
  EXPECT_LT(leftmost, 1e-4f);
  EXPECT_GT(rightmost, 1.0f - 1e-4f);
}

TEST(MapMarks, NoLineJumpsInAnyMap) {
  for (const glm::vec3 direction : testing::manyDirections(60)) {
    const MapMarks marks = marksOf(direction, circleAround(direction, 40.0f));
    for (const MapMark* mark : {&marks.panorama, &marks.cross, &marks.sphere_map}) {
      EXPECT_FALSE(mark->outline.empty());
      for (const auto& line : mark->outline) {
        EXPECT_GE(line.size(), 2u);
        for (std::size_t i = 1; i < line.size(); ++i) EXPECT_LT(glm::distance(line[i - 1], line[i]), 0.021f);
      }
    }
  }
}

}  // namespace
}  // namespace mirrorball
