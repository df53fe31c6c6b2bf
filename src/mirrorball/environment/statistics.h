#pragma once

#include <glm/glm.hpp>

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// What `info` says about the light in a map. Texels that are not finite or are outside a disc are not counted.
struct RadianceStatistics {
  glm::vec3 min{0.0f};
  glm::vec3 max{0.0f};
  glm::vec3 mean{0.0f};                             ///< over the sphere, weighted by solid angle [radiance]
  glm::vec3 brightest_direction{0.0f, 0.0f, 1.0f};  ///< of the texel with the greatest luminance
  glm::vec3 brightest{0.0f};                        ///< its radiance
};

RadianceStatistics radianceStatistics(const EnvironmentMap& map);

}  // namespace mirrorball
