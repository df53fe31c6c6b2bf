#pragma once

#include <compare>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Where a surface's shader finds the texture of one row of materialMaps().
struct MapSource {
  int unit = -1;   ///< of the texture units that a material has, from 0; −1: there is no texture
  int layer = -1;  ///< of the array in this unit; −1: the unit holds the texture itself

  // Of a layer, since the sampler of the array cannot tell them:
  bool srgb = false;
  bool nearest = false;
  Wrap wrap_s = Wrap::repeat;
  Wrap wrap_t = Wrap::repeat;

  bool has_spread = false;  ///< a normal map whose alpha is that of height_field/normal_levels.h
  bool is_decoded = false;  ///< and whose texels are the normals themselves

  auto operator<=>(const MapSource&) const = default;
};

/// Deals a material's textures out to texture units. Rows with the same texture share its unit. Where there are more
/// different textures than units, the largest keep a unit each and the others become layers of an array in the last
/// one.
///
/// units    that the material has: at least 1
/// returns  one source for each row of materialMaps()
std::vector<MapSource> mapSources(const Material& material, std::span<const Texture> textures, int units);

/// The sampler that a row with a texture reads: that of the first row with the same unit, or of all layers.
std::string_view samplerName(std::span<const MapSource> sources, std::size_t row);

}  // namespace mirrorball
