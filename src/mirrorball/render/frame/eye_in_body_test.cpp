// An eye inside of traced bodies: in water, in glass, in a bubble in glass.

#include <cmath>
#include <string>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "mirrorball/render/frame/glass_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using testing::add;
using testing::clearGlass;
using testing::greatestDifference;
using testing::withoutReflection;

constexpr float kWater = 1.333f;

class EyeInBody : public testing::GlassTest {
 protected:
  void SetUp() override {
    GlassTest::SetUp();
    frame_.camera.orthographic_height.reset();
  }
  /// Puts the eye at the origin of a scene of which it is the middle.
  void standInTheMiddle(float azimuth_deg, float elevation_deg, float fov_deg) {
    frame_.camera.distance = 1e-4f;
    frame_.camera.fov_deg = fov_deg;
    testing::aim(frame_, azimuth_deg, elevation_deg);
  }
};

/// A sheet of water.
Scene sea() {
  Scene scene = meshScene(cubeMesh(), clearGlass(kWater));
  scene.instances[0].world_from_object = glm::scale(glm::mat4(1.0f), glm::vec3(500.0f, 1.0f, 500.0f));
  return scene;
}

/// The light that comes through the water's surface, a share of F of which is reflected at each surface that is met, up
/// and down by turns; what is inside after the last is the light from far away in its direction.
float lightFromUnderWater(float f, int surfaces) {
  float light = 0.0f;
  float share = 1.0f;
  for (int surface = 0; surface < surfaces; ++surface, share *= f)
    if (surface % 2 == 0) light += (1.0f - f) * share;
  return surfaces % 2 == 0 ? light + share : light;
}

// Dark below the water: the light above is squeezed into a circle of 48.6°, around which the surface is a mirror.
TEST_F(EyeInBody, FromUnderWaterTheSkyIsInSnellsWindow) {
  const Environment sky([](glm::vec3 d) { return glm::vec3(d.y > 0.0f ? 1.0f : 0.0f); }, 64);
  frame_.size = {512, 4};
  // Not straight up, where the picture's axes would be other ones.
  standInTheMiddle(0.0f, -89.9f, 120.0f);
  frame_.camera.fov_deg = 1.5f;  // of the few rows; along them it is 2 atan(128 tan 0.75°) = 118°
  const float critical_deg = glm::degrees(std::asin(1.0f / kWater));
  ASSERT_NEAR(critical_deg, 48.6f, 0.05f);
  const float half_width = 128.0f * std::tan(glm::radians(0.75f));
  for (const int surfaces : {1, 2, 4}) {
    frame_.inner_bounces = surfaces;
    const Image image = radiance(sea(), sky);
    float widest_deg = 0.0f;
    for (int x = 0; x < 512; ++x) {
      const float across = ((static_cast<float>(x) + 0.5f) / 256.0f - 1.0f) * half_width;
      const float angle_deg = glm::degrees(std::atan(std::abs(across)));
      const float light = rgbAt(image, x, 2).y;
      if (light > 0.1f && angle_deg < critical_deg + 1.0f) widest_deg = std::max(widest_deg, angle_deg);
      // Where the sky is near the horizon, the environment's texels mix it with the dark.
      if (std::abs(angle_deg - critical_deg) < 1.0f) continue;
      const float f = formula::fresnelDielectric(std::cos(glm::radians(angle_deg)), 1.0f / kWater);
      EXPECT_NEAR(light, lightFromUnderWater(f, surfaces), 2e-3f) << angle_deg << " " << surfaces;
    }
    if (surfaces == 1) {
      EXPECT_NEAR(widest_deg, critical_deg, 0.5f);
    }
  }
}

TEST_F(EyeInBody, WhiteStaysWhite) {
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 16);
  Material rough = clearGlass(1.5f);
  rough.perceptual_roughness = 0.4f;
  rough.dispersion = 1.0f;
  Scene nested = meshScene(torusMesh(48, 24), clearGlass(1.7f));
  add(nested, sphereMesh(24, 48), clearGlass(kWater), glm::vec3(0.0f), 4.0f);
  add(nested, sphereMesh(24, 48), rough, glm::vec3(1.5f, 0.0f, 0.0f), 0.5f);
  add(nested, sphereMesh(24, 48), clearGlass(1.0f), glm::vec3(-1.5f, 0.0f, 0.0f), 0.5f);
  for (const glm::vec3 eye : {glm::vec3(0.0f, 0.0f, 2.0f), glm::vec3(-1.5f, 0.0f, 0.0f), glm::vec3(0.7f, 0.0f, 0.0f)}) {
    frame_.camera.target = eye;
    standInTheMiddle(-90.0f, 10.0f, 100.0f);
    for (const int bounces : {1, 4}) {
      frame_.inner_bounces = bounces;
      testing::expectFurnaceWhite(radiance(nested, white), std::to_string(eye.x), 2e-3f);
    }
  }
}

// The eye in the middle of a ball: every ray goes straight out over one radius.
TEST_F(EyeInBody, WaterAbsorbsFromTheSurfaceToTheEye) {
  Material wine = withoutReflection(kWater);
  wine.attenuation_color = {0.9f, 0.5f, 0.25f};
  wine.attenuation_distance = 0.4f;
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 16);
  standInTheMiddle(20.0f, 10.0f, 60.0f);
  const Image image = radiance(meshScene(sphereMesh(128, 256), wine), white);
  const glm::vec3 expected = glm::pow(wine.attenuation_color, glm::vec3(1.0f / 0.4f));
  for (const int x : {3, 32, 60})
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(rgbAt(image, x, 20)[channel], expected[channel], 2e-3f);
}

// From within a bubble or a body of index 1, and where the same substance is behind the next surface.
TEST_F(EyeInBody, SurfacesBetweenTheSameSubstanceAreNotThere) {
  standInTheMiddle(20.0f, 10.0f, 60.0f);
  const Image nothing = inSmoothLight({});
  EXPECT_LT(greatestDifference(inSmoothLight(meshScene(sphereMesh(64, 128), clearGlass(1.0f))), nothing), 1.0 / 255.0);
  const Scene water = meshScene(sphereMesh(64, 128), clearGlass(kWater));
  Scene nested = water;
  add(nested, cubeMesh(), clearGlass(kWater), glm::vec3(0.0f), 0.5f);
  frame_.inner_bounces = 8;
  EXPECT_LT(greatestDifference(inSmoothLight(nested), inSmoothLight(water)), 0.02);
  EXPECT_GT(greatestDifference(inSmoothLight(water), nothing), 0.02) << "Fresnel's reflection at the water's surface";
}

}  // namespace
}  // namespace mirrorball
