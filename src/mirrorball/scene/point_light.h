#pragma once

#include <glm/glm.hpp>

#include "formula/lamp.h"

namespace mirrorball {

/// A point light, for Phong's model.
struct PointLight {
  glm::vec3 position{0.0f};  ///< world
  glm::vec3 color{1.0f};     ///< the radiance that a white diffuse surface facing it shows

  bool operator==(const PointLight&) const = default;
};

/// The same as the formulas take it.
inline formula::Lamp lampOf(const PointLight& light) {
  return {.kind = formula::kLampPhong, .position = light.position, .color = light.color};
}

}  // namespace mirrorball
