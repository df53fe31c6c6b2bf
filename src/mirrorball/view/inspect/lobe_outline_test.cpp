#include "mirrorball/view/inspect/lobe_outline.h"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "mirrorball/rays/frame.h"

namespace mirrorball {
namespace {

glm::vec3 towardsEye(float angle_deg, float azimuth_deg) {
  const float angle = glm::radians(angle_deg), azimuth = glm::radians(azimuth_deg);
  return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
}

glm::vec3 mirrored(glm::vec3 towards) { return {-towards.x, -towards.y, towards.z}; }

/// A direction in a map around another one that keeps angles from it.
glm::vec2 placeAround(const Frame& middle, glm::vec3 direction) {
  const glm::vec3 local = middle.toLocal(direction);
  const float sine = glm::length(glm::vec2(local));
  return sine > 0.0f ? glm::vec2(local) * (std::atan2(sine, local.z) / sine) : glm::vec2(0.0f);
}

bool isEnclosed(const std::vector<glm::vec2>& polygon, glm::vec2 place) {
  bool is_inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.y > place.y) != (b.y > place.y) && place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x))
      is_inside = !is_inside;
  }
  return is_inside;
}

/// Which share of the light that facets send the eye comes from within the outline, by directions that are drawn of it.
float enclosedShare(glm::vec2 alpha, glm::vec3 towards, float share) {
  const Frame middle(mirrored(towards));
  std::vector<glm::vec2> polygon;
  for (const glm::vec3 direction : lobeOutline(alpha, towards, share, 256))
    polygon.push_back(placeAround(middle, direction));
  constexpr int kSide = 150;
  int enclosed = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::vec2 u = (glm::vec2(x, y) + 0.5f) / float(kSide);
      enclosed += isEnclosed(polygon, placeAround(middle, formula::sampleGgx(alpha, towards, u))) ? 1 : 0;
    }
  return float(enclosed) / float(kSide * kSide);
}

// D(h) h.z of GGX has the share t² / (t² + α²) within a slope of t.
TEST(LobeOutline, SeenAlongTheNormalItIsACircle) {
  for (const float share : {0.2f, 0.5f, 0.9f})
    for (const float alpha : {0.01f, 0.3f}) {
      const float facet = std::atan(alpha * std::sqrt(share / (1.0f - share)));
      for (const glm::vec3 direction : lobeOutline(glm::vec2(alpha), {0, 0, 1}, share, 16))
        EXPECT_NEAR(std::acos(std::min(direction.z, 1.0f)), std::min(2.0f * facet, glm::radians(90.0f)), 1e-3f);
    }
}

TEST(LobeOutline, EnclosesItsShareOfTheLight) {
  for (const float share : {0.25f, 0.5f}) {
    EXPECT_NEAR(enclosedShare({0.1f, 0.1f}, towardsEye(0.0f, 0.0f), share), share, 0.01f);
    EXPECT_NEAR(enclosedShare({0.1f, 0.1f}, towardsEye(60.0f, 20.0f), share), share, 0.01f);
    EXPECT_NEAR(enclosedShare({0.3f, 0.3f}, towardsEye(45.0f, 200.0f), share), share, 0.01f);
    EXPECT_NEAR(enclosedShare({0.4f, 0.1f}, towardsEye(40.0f, 30.0f), share), share, 0.01f);
  }
}

TEST(LobeOutline, OfASmoothSurfaceIsTheMirrorDirection) {
  for (const float angle_deg : {0.0f, 30.0f, 80.0f}) {
    const glm::vec3 towards = towardsEye(angle_deg, 50.0f);
    for (const glm::vec3 direction : lobeOutline(glm::vec2(1e-4f), towards, 0.5f, 32))
      EXPECT_LT(glm::distance(direction, mirrored(towards)), 1e-3f) << angle_deg;
  }
}

TEST(LobeOutline, DoesNotSinkBelowTheSurface) {
  for (const float angle_deg : {60.0f, 85.0f, 89.99f, 90.0f})
    for (const float alpha : {1e-4f, 0.5f, 1.0f})
      for (const glm::vec3 direction : lobeOutline(glm::vec2(alpha), towardsEye(angle_deg, 10.0f), 0.5f, 64)) {
        EXPECT_GE(direction.z, 0.0f);
        EXPECT_NEAR(glm::length(direction), 1.0f, 1e-5f);
      }
}

}  // namespace
}  // namespace mirrorball
