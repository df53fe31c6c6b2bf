#include "mirrorball/view/inspect/light_around.h"

#include "formula/proxy.h"

namespace mirrorball {

glm::vec3 environmentDirection(const LightAround& around, glm::vec3 origin, glm::vec3 direction) {
  const bool is_far = around.proxy.kind == ProxyKind::none;
  const glm::vec3 seen = is_far ? direction : sightFrom(around.proxy, origin, direction).direction;
  return glm::normalize(around.environment_from_world * seen);
}

glm::vec3 environmentDirectionOfEye(const LightAround& around, glm::vec3 origin, glm::vec3 direction) {
  if (around.proxy.kind == ProxyKind::none || around.proxy.holds(origin))
    return environmentDirection(around, origin, direction);
  return environmentDirection(around, formula::nearestToCapture(origin, direction, around.proxy.captured_at),
                              direction);
}

glm::vec3 radianceOf(const LightAround& around, glm::vec3 direction) {
  return around.environment ? around.intensity * around.environment->radiance(direction) : glm::vec3(0.0f);
}

}  // namespace mirrorball
