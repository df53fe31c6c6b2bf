#include "mirrorball/render/frame/turntable.h"

#include <glm/gtc/matrix_transform.hpp>

namespace mirrorball {

FrameSettings turned(FrameSettings settings, Turn what, float angle_deg) {
  const float angle_rad = glm::radians(angle_deg);
  switch (what) {
    case Turn::camera:
      settings.camera.azimuth_deg += angle_deg;
      break;
    case Turn::environment:
      settings.env_rotation_rad += angle_rad;
      break;
    case Turn::model: {
      // All else turned the other way looks the same, and leaves the scene as it is.
      settings.camera.azimuth_deg -= angle_deg;
      settings.env_rotation_rad -= angle_rad;
      const glm::vec3 axis = settings.camera.target.value_or(glm::vec3(0.0f));
      const glm::mat4 back = glm::rotate(glm::mat4(1.0f), -angle_rad, glm::vec3(0, 1, 0));
      for (PointLight& light : settings.lights)
        light.position = axis + glm::vec3(back * glm::vec4(light.position - axis, 0.0f));
      break;
    }
  }
  return settings;
}

}  // namespace mirrorball
