#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// A part of a surface that is spread out in the plane by looking at it from one side.
struct Chart {
  std::vector<std::uint32_t> triangles;
  std::vector<std::array<glm::dvec2, 3>> corners;  ///< of each, in units of the mesh; right, and up
};

/// Cuts a mesh into charts: each grows over edges from its largest triangle as long as the next one is turned at most
/// 60° from the chart's mean normal, and keeps those that it does not lay over others. So no chart overlaps itself and
/// no triangle is turned over.
///
/// cost   O(n log n) for charts of bounded number; 2 µs a triangle
/// from   the clustering by normals of Cignoni et al. 1998; Lévy et al. 2002 for charts that must not overlap
std::vector<Chart> chartsOf(const Mesh& mesh);

/// Turns a chart so that the rectangle around it is small and stands upright, with its corner at the origin.
void turnUpright(Chart& chart);

}  // namespace mirrorball
