#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {

/// Marks on the picture of one map. Places are shares of its width and height, from its top left corner.
struct MapMark {
  glm::vec2 dot{0.0f};
  std::vector<std::vector<glm::vec2>> outline;  ///< lines through at least two places each; a seam ends a line
};

/// The same direction, and what lies around it, in three maps at once (docs/conventions.md).
struct MapMarks {
  MapMark panorama;    ///< Projection::equirect, 2:1
  MapMark cross;       ///< Projection::cube as CubeLayout::hcross, 4:3
  MapMark sphere_map;  ///< Projection::sphere, 1:1
};

/// Where maps of the environment show a direction, and an outline around it.
///
/// direction  in the environment's own axes, unit
/// outline    a closed line of such directions, each less than 90° from the next; empty: there is none
/// cost       a look-up a direction of the outline, and some twenty where it crosses a seam
MapMarks marksOf(glm::vec3 direction, std::span<const glm::vec3> outline);

}  // namespace mirrorball
