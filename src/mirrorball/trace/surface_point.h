#pragma once

#include <glm/glm.hpp>

#include "formula/material.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/trace/geometry.h"

namespace mirrorball {

/// A point of a surface with all that its material and its textures say of it: what shaders/surface/ makes of a
/// fragment.
struct SurfacePoint {
  glm::vec3 position{0.0f};          ///< world
  glm::vec3 geometric_normal{0.0f};  ///< of the triangle, unit, outwards
  glm::vec3 normal{0.0f};            ///< of the surface with bumps and normal map, unit, outwards
  formula::Material material;        ///< times what the textures hold here
  float opacity = 1.0f;              ///< 0: cut away; between, what is behind shines through
};

/// Material, textures and normal where a ray has met a scene.
///
/// cost     some 100 ns, and 50 for each texture
SurfacePoint surfacePointAt(const Scene& scene, const Hit& hit);

/// The opacity there alone, for rays that only ask what they pass.
float opacityAt(const Scene& scene, const Hit& hit);

/// The material of what was met.
const Material& materialAt(const Scene& scene, const Hit& hit);

}  // namespace mirrorball
