#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "formula/material.h"

namespace mirrorball {

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

/// As reflectanceAt (rays/surface_shares.h).
FresnelCurve fresnelCurve(const formula::Material& material, float cosine, bool is_inside);

}  // namespace mirrorball
