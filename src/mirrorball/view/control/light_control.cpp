#include "mirrorball/view/control/light_control.h"

#include "mirrorball/view/control/degrees.h"

namespace mirrorball {

glm::vec3 turnedLight(glm::vec3 env_rotation_deg, glm::vec2 by_px, glm::ivec2 size) {
  env_rotation_deg.x = wrappedAngle(env_rotation_deg.x + degreesOf(by_px, size).x);
  return env_rotation_deg;
}

}  // namespace mirrorball
