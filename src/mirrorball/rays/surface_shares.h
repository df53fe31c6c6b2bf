#pragma once

#include <glm/glm.hpp>

#include "formula/material.h"
#include "mirrorball/rays/frame.h"
#include "mirrorball/rays/path_vertex.h"

namespace mirrorball {

// What a smooth surface does with light that a ray meets it along, and by which ways that light goes on. Without what a
// clear coat or cloth adds.

/// What a smooth surface of a material reflects: of facets of that normal.
///
/// material   its index relative to what is on the other side (materialAgainstBeyond)
/// cosine     of the angle between the ray and the normal on its side, in [0, 1]
/// is_inside  the ray meets the surface from within the body. Light that comes out is reflected as light that goes in
///            by the same way (Stokes 1849); 1 past the critical angle
/// returns    linear red, green and blue, in [0, 1]
glm::vec3 reflectanceAt(const formula::Material& material, float cosine, bool is_inside);

/// Whether nothing passes a surface at that angle, which others would let through.
bool isTotallyReflected(const formula::Material& material, float cosine, bool is_inside);

/// How a ray meets a surface.
struct SurfaceView {
  bool is_inside = false;  ///< from within a body
  float cosine = 0.0f;     ///< of the angle between it and the normal on its side, 0 … 1
};
SurfaceView seenSide(const PathVertex& vertex);

/// The frame of the surface on the side that the ray comes from.
Frame frameOnRaysSide(const PathVertex& vertex);

/// Light of all directions at a surface, linear: how much of it goes on to where the ray comes from, by the mirror
/// direction and by the refracted one. The rest is scattered or absorbed.
struct SurfaceShares {
  glm::vec3 reflected{0.0f};
  glm::vec3 refracted{0.0f};
  bool is_total = false;  ///< all is reflected, of a surface that lets light through
};
SurfaceShares sharesAt(const PathVertex& vertex);
/// The same by facets of the normal n, unit and on the ray's side.
SurfaceShares sharesAt(const PathVertex& vertex, glm::vec3 n);

/// Where the ray goes on that facets of the normal n reflect: not below the triangle.
///
/// n    unit, on the ray's side
glm::vec3 reflectedDirection(const PathVertex& vertex, glm::vec3 n);

/// Where it goes on through them, by the index at 588 nm: through a thin wall straight on.
glm::vec3 refractedDirection(const PathVertex& vertex, glm::vec3 n);

}  // namespace mirrorball
