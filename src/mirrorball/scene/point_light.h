#pragma once

#include <glm/glm.hpp>

#include "formula/lamp.h"

namespace mirrorball {

/// A point light, for Phong's model.
struct PointLight {
  glm::dvec3 position{0.0};  ///< in the file's coordinates
  glm::vec3 color{1.0f};     ///< the radiance that a white diffuse surface facing it shows

  bool operator==(const PointLight&) const = default;
};

/// The same as the formulas take it.
///
/// origin   of the scene that it shines on
inline formula::Lamp lampOf(const PointLight& light, glm::dvec3 origin) {
  return {.kind = formula::kLampPhong, .position = glm::vec3(light.position - origin), .color = light.color};
}

}  // namespace mirrorball
