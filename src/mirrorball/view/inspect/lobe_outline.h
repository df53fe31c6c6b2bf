#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {

/// The directions that bound a share of what a rough mirror of GGX's facets reflects, around the mirror direction, in
/// closed form: of what each single facet sends to the eye, all reflecting alike. Stretched by 1 / alpha, facets
/// are a hemisphere, and those that the eye sees reflect its ray evenly into a spherical cap (Dupuy & Benyoub 2023,
/// "Sampling visible GGX normals with spherical caps"; formula/bsdf/ggx.glsl samples the same). In each wedge of that
/// cap about its mirror direction the outline keeps the share that is nearest to it.
///
/// alpha    widths along the tangent and the bitangent, above 0
/// towards  unit, in the frame of the surface, whose normal is +Z: to the eye, above the surface
/// share    in (0, 1)
/// count    of directions, which go once around; at least 3
/// returns  in that frame, unit. Those below the surface, from where light meets another facet first, are moved up to
///          its horizon
std::vector<glm::vec3> lobeOutline(glm::vec2 alpha, glm::vec3 towards, float share, int count);

}  // namespace mirrorball
