#include "mirrorball/view/control/light_control.h"

#include <gtest/gtest.h>

#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {
namespace {

// Light from behind the camera lies in front of the model: as the hand goes to the right, so does it.
TEST(LightControl, LightBeforeTheModelMovesWithTheHand) {
  FrameSettings settings;
  settings.camera = {.azimuth_deg = 0.0f, .elevation_deg = 0.0f};
  const glm::vec3 towards_eye(0, 0, 1);
  const glm::vec3 lamp = settings.environmentFromWorld() * towards_eye;  // of the environment
  settings.env_rotation_deg = turnedLight(settings.env_rotation_deg, {20, 0}, {200, 300});
  const glm::vec3 seen = glm::transpose(settings.environmentFromWorld()) * lamp;
  EXPECT_GT(seen.x, 0.2f);
  EXPECT_NEAR(glm::degrees(std::atan2(seen.x, seen.z)), 18.0f, 1e-3f);
}

TEST(LightControl, KeepsTheHorizonAndTheRange) {
  const glm::vec3 turned = turnedLight({170, 5, 7}, {20, 99}, {200, 300});
  EXPECT_FLOAT_EQ(turned.x, -172.0f);
  EXPECT_FLOAT_EQ(turned.y, 5.0f);
  EXPECT_FLOAT_EQ(turned.z, 7.0f);
}

}  // namespace
}  // namespace mirrorball
