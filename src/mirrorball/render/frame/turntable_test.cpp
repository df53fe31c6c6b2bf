#include "mirrorball/render/frame/turntable.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

FrameSettings settingsOf(float azimuth_deg) {
  FrameSettings settings;
  settings.camera.azimuth_deg = azimuth_deg;
  settings.camera.target = glm::vec3(10, 0, 0);
  settings.env_rotation_deg.x = 30.0f;
  settings.lights = {{.position = {10, 5, 2}}};
  return settings;
}

TEST(Turned, TheCameraOrTheEnvironmentAlone) {
  const FrameSettings camera = turned(settingsOf(20.0f), Turn::camera, 90.0f);
  EXPECT_EQ(camera.camera.azimuth_deg, 110.0f);
  EXPECT_EQ(camera.env_rotation_deg.x, 30.0f);
  const FrameSettings environment = turned(settingsOf(20.0f), Turn::environment, 90.0f);
  EXPECT_EQ(environment.camera.azimuth_deg, 20.0f);
  EXPECT_FLOAT_EQ(environment.env_rotation_deg.x, 120.0f);
  EXPECT_EQ(environment.lights[0].position, settingsOf(20.0f).lights[0].position);
}

// A model that turns by 90°, +Z towards +X, shows a camera on +Z what a camera on −X saw of it. The environment and the
// lights stay where the camera has them: the light that stood 2 towards the camera does so still.
TEST(Turned, TheModelBeforeCameraEnvironmentAndLights) {
  const FrameSettings model = turned(settingsOf(0.0f), Turn::model, 90.0f);
  EXPECT_EQ(model.camera.azimuth_deg, -90.0f);
  EXPECT_FLOAT_EQ(model.env_rotation_deg.x, -60.0f);
  EXPECT_LT(glm::distance(model.lights[0].position, glm::vec3(8, 5, 0)), 1e-5f);
}

}  // namespace
}  // namespace mirrorball
