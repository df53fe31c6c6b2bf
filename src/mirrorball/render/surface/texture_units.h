#pragma once

#include "mirrorball/gl/texture.h"
#include "mirrorball/render/surface/surface_variant.h"

namespace mirrorball {

/// The texture units that the shaders read from. Of those with one number a shader reads at most one: who draws binds
/// it.
struct TextureUnit {
  static constexpr int environment = 0;
  static constexpr int sphere_map = 1;  ///< which shows what is infinitely far away: no proxy, and no nearness
  static constexpr int proxy = 1;
  static constexpr int nearness = 1;  ///< a probe's, which no proxy lies behind
  static constexpr int picture = 2;
  static constexpr int background = 2;  ///< no shader reads two of these
  static constexpr int bodies = 2;
  static constexpr int back_faces = 2;
  static constexpr int scene_triangles = 2;
  static constexpr int brdf_table = 3;
  static constexpr int prefiltered = 4;
  static constexpr int irradiance = 5;
  static constexpr int mirror_picture = 6;  ///< read when no material is bound
  static constexpr int mirror_depths = 7;
  static constexpr int first_of_material = 6;
  static constexpr int opaque_picture = first_of_material + kUnitsBesideScreen;
  static constexpr int scene_triangles_of_glass = opaque_picture + 1;  ///< which reads its bodies as well
  static constexpr int of_material = gl::Texture::kUnits - first_of_material;
  static constexpr int relief_hits = gl::Texture::kUnits - 5;
  static constexpr int horizons = gl::Texture::kUnits - 4;
  static constexpr int prisms = gl::Texture::kUnits - 3;
  static constexpr int heights = gl::Texture::kUnits - 2;  ///< of a material that has them
  static constexpr int slopes = gl::Texture::kUnits - 1;   ///< of heights, or a map of slopes
};

}  // namespace mirrorball
