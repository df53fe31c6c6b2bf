#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// The shape of a mesh by few triangles: enough for its shadow.
struct CoarseMesh {
  std::vector<glm::vec3> positions;    ///< object space
  std::vector<std::uint32_t> indices;  ///< three a triangle
};

/// Joins vertices that are near each other (meshoptimizer's sloppy simplification, or by a grid in a build without it):
/// fast, and without regard to edges.
///
/// triangles   about as many at most; a mesh that has no more stays as it is
/// cost        10 ms for 65 000 triangles
CoarseMesh coarseMesh(const Mesh& mesh, std::size_t triangles);

}  // namespace mirrorball
