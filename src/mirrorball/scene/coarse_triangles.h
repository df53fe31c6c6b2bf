#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// Joins vertices that lie near each other, whatever edges are between them: about so many triangles are left at most.
///
/// mesh     has more triangles than that
/// returns  indices of its vertices, three a triangle
std::vector<std::uint32_t> coarseTriangles(const Mesh& mesh, std::size_t triangles);

}  // namespace mirrorball
