#include "mirrorball/environment/builtin/studio.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "formula/color.h"
#include "formula/constants.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/projection/direction_angles.h"

namespace mirrorball {
namespace {

using testing::manyDirections;

float luminanceAlong(glm::vec3 d) { return formula::luminance(studioRadiance(glm::normalize(d))); }

/// The built-in cube has its sides at ±1/√3.
const float kHalfSide = 1.0f / std::sqrt(3.0f);

/// What a mirror cube shows at a place of the side with that normal.
float mirrored(glm::vec3 place, glm::vec3 normal, glm::vec3 camera) {
  return luminanceAlong(glm::reflect(place - camera, normal));
}

// The studio before this one lit it from all around: 0.24 … 2.3, of which a display showed white nearly everywhere.
TEST(Studio, AWhiteBallHasLightAndShade) {
  const std::vector<glm::vec3> directions = manyDirections(4000);
  const glm::vec3 camera = directionAtAngles(30, 15);
  float min = 10.0f;
  float max = 0.0f;
  for (const glm::vec3& normal : manyDirections(200)) {
    if (glm::dot(normal, camera) < 0.1f) continue;
    float light = 0.0f;
    for (const glm::vec3& d : directions)
      if (glm::dot(d, normal) > 0.0f) light += luminanceAlong(d) * glm::dot(d, normal) * (4.0f / 4000.0f);
    min = std::min(min, light);
    max = std::max(max, light);
  }
  EXPECT_NEAR(min, 0.15f, 0.02f);
  EXPECT_NEAR(max, 1.1f, 0.05f);
}

TEST(Studio, IsGreyAndHalfAsBrightAsAWhiteOne) {
  glm::vec3 mean(0.0f);
  float max = 0.0f;
  for (const glm::vec3& d : manyDirections(20000)) {
    mean += studioRadiance(d) / 20000.0f;
    max = std::max(max, luminanceAlong(d));
  }
  EXPECT_NEAR(formula::luminance(mean), 0.51f, 0.02f);
  EXPECT_NEAR(mean.x / mean.y, 1.0f, 0.02f);
  EXPECT_NEAR(mean.z / mean.y, 1.0f, 0.02f);
  EXPECT_NEAR(max, 7.0f, 0.2f);
}

// From the camera that render has, and a little higher: the three sides that are seen tell apart at their edges and
// from what is behind them, and show a lamp or its image in the floor,
// of which there was none in the studio before this one.
TEST(Studio, TheSidesOfAMirrorCubeStandOut) {
  const std::vector<glm::vec3> sides{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const float elevation : {15.0f, 20.0f, 25.0f}) {
    const glm::vec3 camera = 3.9f * directionAtAngles(30, elevation);
    float brightest = 0.0f;
    for (std::size_t a = 0; a < 3; ++a) {
      const glm::vec3 one = sides[a];
      const glm::vec3 other = sides[(a + 1) % 3];
      const glm::vec3 along = glm::cross(one, other);
      float at_edge = 0.0f;    // mean of |ln|, in nine places
      float to_behind = 0.0f;  // in 81
      for (int i = -4; i <= 4; ++i) {
        const glm::vec3 edge = kHalfSide * (one + other + along * (static_cast<float>(i) / 5.0f));
        const float beside = mirrored(edge - 0.1f * kHalfSide * other, one, camera);
        at_edge += std::abs(std::log(beside / mirrored(edge - 0.1f * kHalfSide * one, other, camera))) / 9.0f;
        for (int j = -4; j <= 4; ++j) {
          const glm::vec3 place =
              kHalfSide * (one + (along * static_cast<float>(i) + other * static_cast<float>(j)) / 4.5f);
          brightest = std::max(brightest, mirrored(place, one, camera));
          to_behind += std::abs(std::log(mirrored(place, one, camera) / luminanceAlong(place - camera))) / 81.0f;
        }
      }
      EXPECT_GT(at_edge, 0.25f) << "edge " << a << " from " << elevation;
      EXPECT_GT(to_behind, 0.3f) << "side " << a << " from " << elevation;
    }
    EXPECT_GT(brightest, 0.8f) << "from " << elevation;
  }
}

// A texel of a panorama of 1024 rows is 0.003 rad wide.
TEST(Studio, LampsHaveSoftEdges) {
  const float texel_rad = formula::kPi / 1024.0f;
  for (const glm::vec3& d : manyDirections(20000)) {
    const glm::vec3 aside = glm::normalize(glm::cross(d, glm::vec3(0.6f, 0.5f, 0.62f)));
    EXPECT_LT(std::abs(luminanceAlong(d + texel_rad * aside) - luminanceAlong(d)), 0.08f * 7.0f);
  }
}

}  // namespace
}  // namespace mirrorball
