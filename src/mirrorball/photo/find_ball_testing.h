#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/codec/ldr/jpeg.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/photo/find_ball.h"
#include "mirrorball/photo/photo_testing.h"

namespace mirrorball::testing {

inline RadianceFunction builtin(const char* name) {
  return [environment = *builtinEnvironment(name)](glm::vec3 d) { return environment.radiance(d); };
}

/// Overlapping rectangles and elliptic discs of all sizes and shades, with hard edges; the same for a seed.
inline RadianceFunction clutter(unsigned seed, bool with_discs = true) {
  struct Thing {
    glm::vec2 middle, half;
    glm::vec3 color;
    bool is_disc;
  };
  std::mt19937 random(seed);
  const auto uniform = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  std::vector<Thing> things;
  for (int i = 0; i < 120; ++i) {
    const float size = std::pow(10.0f, uniform(-2.2f, -0.9f));
    things.push_back({{uniform(-0.45f, 0.45f), uniform(-0.35f, 0.35f)},
                      {size * uniform(0.5f, 1.5f), size * uniform(0.5f, 1.5f)},
                      {uniform(0.02f, 0.9f), uniform(0.02f, 0.9f), uniform(0.02f, 0.9f)},
                      with_discs && i % 3 == 0});
  }
  return [things](glm::vec3 ray) {
    const glm::vec2 p(ray.x / -ray.z, ray.y / -ray.z);
    // The last one lies on top.
    for (auto thing = things.rbegin(); thing != things.rend(); ++thing) {
      const glm::vec2 away = glm::abs(p - thing->middle) / thing->half;
      if (thing->is_disc ? glm::dot(away, away) < 1.0f : std::max(away.x, away.y) < 1.0f) return thing->color;
    }
    return glm::vec3(0.2f);
  };
}

/// What a camera makes of light: sRGB codes, through JPEG, and back.
inline Image throughJpeg(const Image& light) {
  const Bytes bytes = *encodeJpeg(pictureFromLinear(light, 3), {});
  return decodeJpeg(bytes)->image;
}

/// The max_distance distance of the true outline from the found rim.
inline double outlineError_px(const BallScene& scene, const FoundBall& found) {
  double max_distance = 0.0;
  for (const glm::dvec2 position : scene.outline(180)) {
    const glm::dvec2 plane = found.view.pinhole().planeFromPicture(position);
    max_distance =
        std::max(max_distance, std::abs(glm::distance(plane, found.view.rim().center_px) - found.view.rim().radius_px));
  }
  return max_distance;
}

// The bound of 0.3 px is what is promised. A shift of 0.3 px moves the light in the middle of a ball of 100 px radius
// by 0.3°.
inline constexpr double kPromised_px = 0.3;

/// How much of it is in the picture becomes `visible`.
inline void expectFound(const BallScene& scene, const Image& photograph, double bound_px = kPromised_px,
                        double* visible = nullptr) {
  const auto found = findBall(photograph, {.distance = 0.0, .focal_px = scene.focal_px});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(outlineError_px(scene, *found), bound_px);
  EXPECT_GT(found->share, 0.5);
  if (visible) *visible = found->visible;
}

}  // namespace mirrorball::testing
