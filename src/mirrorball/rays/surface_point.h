#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "formula/material.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A point of a surface with all that its material and its textures say of it: what shaders/surface/ makes of a
/// fragment.
struct SurfacePoint {
  glm::vec3 normal{0.0f};           ///< of the surface with bumps and normal map, unit, outwards
  glm::vec4 tangent{0.0f};          ///< of growing u; the sign of the bitangent
  glm::vec2 stretched{1.0f, 0.0f};  ///< cosine and sine of the angle from there to the way that roughness is stretched
  glm::vec3 coat_normal{0.0f};      ///< of a clear coat, unit, outwards; 0 where there is none
  formula::Material material;       ///< times what the textures hold here
};

/// What turns the normals of each instance's mesh into the world's: not their lengths.
std::vector<glm::mat3> normalMatrices(const Scene& scene);

/// Material, textures and normal where a ray has met a scene.
///
/// world_from_normal   of the instance: normalMatrices
/// relief              none: heights do not change the normal
/// cost                four texels for each texture of the material
SurfacePoint surfacePointAt(const Scene& scene, const glm::mat3& world_from_normal, const Hit& hit, ReliefKind relief);

/// The opacity there alone, for rays that only ask what they pass.
float opacityAt(const Scene& scene, const Hit& hit);

}  // namespace mirrorball
