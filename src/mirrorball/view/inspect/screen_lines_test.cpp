#include "mirrorball/view/inspect/screen_lines.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mirrorball/scene/camera/eye_rays.h"
#include "mirrorball/view/inspect/inspect_testing.h"

namespace mirrorball {
namespace {

constexpr glm::ivec2 kSize{80, 60};

Camera perspective() {
  return makeCamera({.azimuth_deg = 20.0f, .elevation_deg = 10.0f, .distance = 3.0f}, {}, 80.0f / 60.0f);
}

RayPath pathOf(glm::vec3 from, glm::vec3 to) {
  RayPath path;
  path.segments.push_back({.from = from, .to = to});
  return path;
}

TEST(ScreenLines, EndWhereTheEyeSeesTheirEnds) {
  for (const Camera& camera : {perspective(), testing::parallelCamera(20.0f, 10.0f)}) {
    const EyeRays rays(camera, kSize);
    const auto placeAt = [&](glm::vec2 pixel, float distance) {
      const EyeRay ray = rays.through(pixel);
      return ray.origin + distance * ray.direction;
    };
    const glm::vec2 a(12.5f, 7.0f), b(61.0f, 44.25f);
    const auto lines = projected(pathOf(placeAt(a, 2.5f), placeAt(b, 3.5f)), camera, kSize);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_LT(glm::distance(lines[0].from, a), 1e-3f);
    EXPECT_LT(glm::distance(lines[0].to, b), 1e-3f);
  }
}

TEST(ScreenLines, AreCutAtTheNearPlane) {
  const Camera camera = perspective();
  const glm::vec3 behind = camera.position - 2.0f * camera.forward + glm::vec3(0.3f, 0.2f, 0.0f);
  for (const bool is_turned : {false, true}) {
    const auto lines =
        projected(is_turned ? pathOf(behind, glm::vec3(0.0f)) : pathOf(glm::vec3(0.0f), behind), camera, kSize);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_LT(glm::distance(is_turned ? lines[0].to : lines[0].from, glm::vec2(kSize) / 2.0f), 1e-3f);
    // Where the segment is 1.99 before the eye: the near plane is 1.01 radii before the middle.
    const float part = 1.01f / 5.0f;
    const auto cut = projected(pathOf(glm::vec3(0.0f), part * 0.9999f * behind), camera, kSize);
    EXPECT_LT(glm::distance(is_turned ? lines[0].from : lines[0].to, cut[0].to), 0.3f);
  }
}

TEST(ScreenLines, BehindTheEyeNothingIsDrawn) {
  const Camera camera = perspective();
  RayPath path = pathOf(camera.position - camera.forward, camera.position - 2.0f * camera.forward);
  path.segments.push_back({.from = glm::vec3(0.0f), .to = glm::vec3(std::numeric_limits<float>::quiet_NaN())});
  path.segments.push_back({.from = glm::vec3(0.0f), .to = glm::vec3(0.1f)});
  const auto lines = projected(path, camera, kSize);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].segment, 2u);
  EXPECT_TRUE(projected({}, camera, kSize).empty());
}

}  // namespace
}  // namespace mirrorball
