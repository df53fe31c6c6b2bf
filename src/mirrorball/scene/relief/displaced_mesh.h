#pragma once

#include <cstdint>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// How fine the triangles are.
struct DisplacementSettings {
  float texels_per_triangle = 1.0f;         ///< the widest that a triangle may be; fewer are taken where it is cheap
  std::uint64_t max_triangles = 8'000'000;  ///< of all meshes with heights; for these triangles are made wider
};

/// Cuts the triangles of meshes whose material has a height texture along the lines between the texels' centres, and
/// puts their corners where the surface is (relief_surface.h). The new vertices have its normals; all else is
/// interpolated. The materials then have no heights any more.
///
/// Triangles that share vertices stay without gaps: an edge is cut by where it is on the texture, the same way from
/// both sides. Where vertices only lie at the same place, a seam of the texture or a sharp edge, gaps open as far as
/// the heights or the normals of both sides differ.
///
/// The vertices that there were stay in the list, where they are and without triangles: so a model is as large, and its
/// camera stands where it does, as with other kinds of relief.
///
/// scene    is warned of meshes without texture coordinates, which stay as they are, and of triangles that are wider
///          than asked for
/// errors   too_large
/// cost     0.5 µs a triangle, 50 bytes
Result<void> displaceMeshes(Scene& scene, const DisplacementSettings& settings = {});

}  // namespace mirrorball
