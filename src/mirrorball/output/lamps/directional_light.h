#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/light_edit/map_lamp.h"

namespace mirrorball {

/// A lamp as engines have it: a light from one direction.
struct DirectionalLight {
  std::string name;        ///< "lamp 1"
  glm::vec3 towards;       ///< the lamp; unit, our axes
  glm::vec3 color;         ///< linear, the greatest channel 1
  float intensity;         ///< times the colour: the irradiance of a surface that faces it
  float angular_size_rad;  ///< its diameter
};

std::vector<DirectionalLight> directionalLights(std::span<const MapLamp> lamps);

}  // namespace mirrorball
