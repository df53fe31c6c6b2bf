#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// A region of a map that outshines the rest: the sun, a bulb, a soft box.
struct Lamp {
  glm::vec3 direction{0.0f};    ///< of its middle, weighed by luminance; unit
  float solid_angle_sr = 0.0f;  ///< of what is at least half as bright as its brightest place
  glm::vec3 radiance{0.0f};     ///< mean over that
  glm::vec3 irradiance{0.0f};   ///< ∫ radiance over all of the region: of a surface that faces it
  float share = 0.0f;           ///< of ∫ luminance over the sphere, 0 … 1

  /// Of a disc of that solid angle [rad], at most π.
  float angularRadius() const;
};

/// The lamps of a map: texels brighter than eight times the mean of the map without them (brightLights,
/// bake/prefilter/bright_lights.h), those that touch each other at a side or a corner as one; of less than a thousandth
/// of the light it is none. A bright sky is none either, as it is the mean.
///
/// cube     finite, not negative
/// all      ∫ radiance over the sphere
/// max      how many of them, by the luminance of their irradiance
/// returns  the strongest first
/// cost     three passes over the texels, and 0.3 µs for each that is bright
std::vector<Lamp> lampsOf(const EnvironmentMap& cube, glm::vec3 all, std::size_t max);

}  // namespace mirrorball
