#pragma once

#include <cstddef>

#include <glm/glm.hpp>

#include "formula/relief.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/mesh.h"
#include "mirrorball/scene/relief/height_texture.h"

namespace mirrorball {

// The surface that a mesh with heights stands for. A place of a triangle, interpolated between its corners, is moved
// along their interpolated normal, whose length is left as it is, by (h − 1) · height_scale of the mesh's units: so it
// lies below the triangles, and there are no gaps between them. h is the bilinear surface of the heights.

/// A triangle of a mesh with the space below it, in the mesh's own.
///
/// first     of its three indices
/// returns   not joined to others, and of all heights
/// heights   where the material's texture has them
formula::ReliefPrism reliefPrism(const Mesh& mesh, std::size_t first, const Material& material,
                                 const HeightTexture& heights);

/// How far a mesh's vertices are from its origin, at most.
float reachOf(const Mesh& mesh);

/// Between which heights rays are looked for in a prism: ReliefPrism::heights. The surface is there; where a relief is
/// so thin that the places of a ray are rounded by some of it, there is room for that.
///
/// prism     in its mesh's space, by reliefPrism
/// bounds    HeightTexture::bounds of the heights that it was made with
/// reach     of the mesh
/// cost      some 64 cells
glm::vec2 heightsBelow(const formula::ReliefPrism& prism, const HeightBounds& bounds, float reach);

/// The unit normal, for shading, of a place of that surface, in the mesh's space. The slopes of the heights are central
/// differences at the texels, interpolated between them.
///
/// prism      of the triangle, by reliefPrism
/// depth      Material::height_scale
/// x_y        of the place, in the prism
/// cost       16 texels
/// from       Blinn 1978; displacedNormal, formula/surface/tangent.glsl
glm::vec3 reliefNormal(const HeightTexture& heights, const formula::ReliefPrism& prism, float depth, glm::vec2 x_y);

}  // namespace mirrorball
