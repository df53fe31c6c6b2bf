#pragma once

#include <functional>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// A texel of a panorama or a cube.
struct MapTexel {
  int face = 0;
  glm::ivec2 place{0};
};

/// Whether the neighbours of a map's texels are known here: of a panorama and both kinds of cube.
bool hasKnownNeighbours(Projection projection);

/// The texel beside another, over seams, poles and a cube's edges too.
///
/// step     −1, 0 or 1 along each axis
MapTexel texelBeside(const EnvironmentMap& map, const MapTexel& texel, glm::ivec2 step);

/// The unit direction of a texel's centre, with all its digits.
glm::dvec3 directionOf(const EnvironmentMap& map, const MapTexel& texel);

glm::vec3 radianceOf(const EnvironmentMap& map, const MapTexel& texel);

/// The angle [rad] that a texel spans where it spans most.
float texelWidth_rad(const EnvironmentMap& map);

/// Calls `visit(texel, direction of its centre)` for all texels whose centres are less than an angle away from a
/// direction (unit), in their order.
///
/// cost     a test for each 16 × 16 texels of the map, and 0.1 µs for each texel that is near
void forEachTexelNear(const EnvironmentMap& map, glm::vec3 direction, float angle_rad,
                      const std::function<void(const MapTexel&, glm::dvec3)>& visit);

}  // namespace mirrorball
