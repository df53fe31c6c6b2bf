#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {

/// Which way light goes at a surface, seen from the eye.
enum class RayTurn { reflected, totally_reflected, refracted };

/// A straight piece of a path, from one surface to the next.
struct RaySegment {
  glm::vec3 from{0.0f};               ///< world, on the surface that it leaves
  glm::vec3 to{0.0f};                 ///< world, on the one that it meets; outside of the scene where it meets none
  RayTurn turn = RayTurn::reflected;  ///< at `from`
  bool is_inside = false;             ///< of a body, at `from`
  glm::vec3 share{1.0f};              ///< of light along it, linear: how much of it gets to the eye by this path
};

/// How a path ends.
enum class PathEnd {
  environment,  ///< it meets nothing more
  matt,   ///< no ray stands for what a further surface shows: half of its lobe is more than 30° away, or it has none
  faint,  ///< less than a thousandth of what comes from there would get to the eye
  limit,  ///< there are more surfaces
};

/// Light on one way to the eye, followed backwards.
struct RayPath {
  std::vector<RaySegment> segments;  ///< from the surface that the eye sees on; empty: the eye sees the environment
  PathEnd end = PathEnd::environment;
  // Of PathEnd::environment; else 0 and empty:
  glm::vec3 direction{0.0f};  ///< where maps show its light, in the environment's own axes, unit
  glm::vec3 radiance{0.0f};   ///< of that light, linear; times the last segment's share it is what gets to the eye
  /// Of a rough surface: the directions, likewise, that bound half of the light which it shows (lobeOutline), if
  /// nothing is in the way of the path; else empty.
  std::vector<glm::vec3> lobe;
};

}  // namespace mirrorball
