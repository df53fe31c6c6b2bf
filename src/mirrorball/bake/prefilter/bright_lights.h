#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// By how much a texel is brighter than the rest of its map.
struct Excess {
  int face = 0;
  glm::ivec2 texel{0};
  glm::vec3 radiance{0.0f};
};

/// A point of light.
struct PointOfLight {
  glm::vec3 direction{0.0f};  ///< unit
  glm::vec3 flux{0.0f};       ///< radiance times solid angle
};

/// The lamps of a map that stand out by themselves: the sun, bulbs.
struct BrightLights {
  std::vector<Excess> texels;        ///< in their order: what the map has without them is the rest
  std::vector<PointOfLight> points;  ///< the same light: a texel's centre each
  bool is_complete = true;           ///< more points would not make the rest any smoother
};

/// The brightest texels of a map, each with its excess over the brightest of the rest. All of them are brighter than
/// eight times the mean of the map without them. Near a panorama's poles, where texels are narrow, those beside each
/// other share a point as long as they are together no wider than a quarter of their height.
///
/// max      points at most; if more texels than that are alike, none of them is taken
/// cost     one pass over the texels, and three over the rows that have bright ones
BrightLights brightLights(const EnvironmentMap& map, int max);

/// Subtracts these lights from the map.
void subtract(const BrightLights& lights, EnvironmentMap& map);

}  // namespace mirrorball
