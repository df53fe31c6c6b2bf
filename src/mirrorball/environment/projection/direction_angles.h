#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace mirrorball {

/// The unit direction at an azimuth (0 is +Z, 90 is +X) and an elevation, in degrees.
inline glm::vec3 directionAtAngles(float azimuth_deg, float elevation_deg) {
  const float azimuth = glm::radians(azimuth_deg);
  const float elevation = glm::radians(elevation_deg);
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)};
}

}  // namespace mirrorball
