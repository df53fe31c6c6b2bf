#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// What a bright texel has more than its fellows: a point of light.
struct BrightTexel {
  int face = 0;
  glm::ivec2 texel{0};
  glm::vec3 direction{0.0f};  ///< unit, of the texel's centre
  glm::vec3 radiance{0.0f};   ///< that exceeds
  float solid_angle = 0.0f;   ///< [sr]
};

/// In the order of the texels.
using BrightTexels = std::vector<BrightTexel>;

/// The brightest texels of a map, with what they exceed the brightest of the rest by: without it the map has no lamp that
/// stands out by itself. Texels that are less than eight times as bright as the mean never count.
///
/// most     how many at most
/// cost     two passes over the texels
BrightTexels brightTexels(const EnvironmentMap& map, int most);

/// Takes that excess out of a map.
void subtract(const BrightTexels& texels, EnvironmentMap& map);

}  // namespace mirrorball
