#pragma once

#include <glm/glm.hpp>

namespace mirrorball {

/// A point light, for Phong's model.
struct PointLight {
  glm::vec3 position{0.0f};  ///< world
  glm::vec3 color{1.0f};     ///< the radiance that a white diffuse surface facing it shows
};

}  // namespace mirrorball
