#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {

/// A region of a map that outshines the rest: the sun, a bulb, a window, a soft box. It shines from infinitely far away
/// (formula::Lamp is a light of a model, with a place).
///
/// All light is in the map's own unit: where its radiance is in cd/m², irradiance is in lx.
struct MapLamp {
  glm::vec3 direction{0.0f};      ///< towards its middle, weighed by luminance; unit
  glm::vec3 irradiance{0.0f};     ///< ∫ radiance over its region: of a surface that faces it
  float angular_size_rad = 0.0f;  ///< diameter of the disc whose light is spread as widely about its middle
  float share = 0.0f;             ///< of ∫ luminance over the sphere, 0 … 1
  /// The corners of a convex outline around its body (unit), counter-clockwise about its direction (as seen from
  /// outside).
  std::vector<glm::vec3> outline = {};
  bool is_clipped = false;  ///< its brightest texels are all as bright as any can be: its light is a lower bound

  /// The luminance of its irradiance.
  float illuminance() const;
  /// Of a disc of its size.
  float solidAngle_sr() const;
  /// Mean over that disc.
  glm::vec3 radiance() const;
  /// How far its outline is from its middle, at most.
  float reach_rad() const;
};

/// A lamp of a map that is turned.
///
/// turn     a rotation
MapLamp turned(MapLamp lamp, const glm::mat3& turn);

/// The angle between two unit directions [rad], exact for small ones, too.
double angleBetween(glm::dvec3 a, glm::dvec3 b);

}  // namespace mirrorball
