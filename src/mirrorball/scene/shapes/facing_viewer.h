#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace mirrorball {

/// From the own frame of a built-in arrangement, in which the viewer stands on +Z, to the world, where he stands at
/// azimuth 30°, as the default camera does.
inline glm::mat4 facingViewer() { return glm::rotate(glm::mat4(1.0f), glm::radians(30.0f), glm::vec3(0, 1, 0)); }

}  // namespace mirrorball
