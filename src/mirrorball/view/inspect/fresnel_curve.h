#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "formula/material.h"

namespace mirrorball {

/// What a smooth surface of a material reflects: of facets of that normal, without what a clear coat or cloth adds.
///
/// material   its index relative to what is on the other side (materialAgainstBeyond)
/// cosine     of the angle between the ray and the normal on its side, in [0, 1]
/// is_inside  the ray meets the surface from within the body. Light that comes out is reflected as light that goes in
///            by the same way (Stokes 1849); 1 past the critical angle
/// returns    linear red, green and blue, in [0, 1]
glm::vec3 reflectanceAt(const formula::Material& material, float cosine, bool is_inside);

/// Whether nothing passes a surface at that angle, which others would let through.
bool isTotallyReflected(const formula::Material& material, float cosine, bool is_inside);

/// What is reflected at an angle.
struct FresnelSample {
  float angle_deg = 0.0f;       ///< from the normal, 0 … 90
  glm::vec3 reflectance{0.0f};  ///< reflectanceAt
};

/// Fresnel's curve of a material, with the angle at which it is seen.
struct FresnelCurve {
  std::vector<FresnelSample> samples;  ///< of each degree, 0 … 90
  FresnelSample here;
};

/// As reflectanceAt.
FresnelCurve fresnelCurve(const formula::Material& material, float cosine, bool is_inside);

}  // namespace mirrorball
