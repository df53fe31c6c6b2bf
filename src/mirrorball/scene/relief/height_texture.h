#pragma once

#include <span>
#include <string_view>

#include "formula/relief.h"
#include "mirrorball/base/result.h"
#include "mirrorball/height_field/height_bounds.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/height_field/horizon_map.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// Heights on a surface, over its texture coordinates.
struct HeightTexture {
  Image heights;  ///< 1 channel, from 0 (deepest) to 1 (the surface itself)
  /// The heights and levels of maxima in one picture, as formula/relief/height_map.glsl reads it; empty: not made, and
  /// only single heights can be read.
  Image picture = {};
  HeightBounds bounds = {};  ///< of the heights; made with the picture
  Image cones = {};          ///< coneMap of the heights; empty: not made
  HorizonMap horizons = {};  ///< of the heights; empty: not made
  MapEdges edges = MapEdges::tiled;
};

/// What formulas know of it.
formula::HeightMap heightMapOf(const HeightTexture& texture);

/// As formulas read it.
inline glm::vec4 fetchMap(const HeightTexture& texture, glm::ivec2 texel, int) {
  // So far away that neighbouring texels are the same number, formulas cannot wrap them.
  const Image& picture = texture.picture.empty() ? texture.heights : texture.picture;
  const glm::ivec2 last(picture.width() - 1, picture.height() - 1);
  const glm::ivec2 inside = glm::clamp(texel, glm::ivec2(0), last);
  return {picture.texel(inside.x, inside.y)[0], 0.0f, 0.0f, 1.0f};
}

/// A texture of these heights that can be searched.
///
/// heights   1 channel, [0, 1]
/// errors    as makeSearchable's
/// cost      as makeSearchable's
Result<HeightTexture> heightTexture(Image heights, MapEdges edges);

/// How many texels across and down the picture has that search reads: one and a half times as many the longer way.
glm::ivec2 sizeOfPicture(const HeightTexture& texture);

/// Makes its picture and bounds, once.
///
/// errors    non_finite (the first bad texel is named); too_large
/// cost      as three maximum pyramids
Result<void> makeSearchable(HeightTexture& texture);

/// 1 − h of each: the same surface as it is from below.
Image turnedOver(Image heights);

/// Makes its cones, once.
///
/// errors    as coneMap's
/// cost      512² in 0.5 s on two cores
Result<void> makeCones(HeightTexture& texture);

/// Makes its horizons, once.
///
/// errors    as horizonMap's
/// cost      512² in 50 ms on two cores
Result<void> makeHorizons(HeightTexture& texture);

/// The surfaces that are functions (formula/relief/builtin_height.glsl), in its order; `map` is a picture's.
enum class HeightKind { none, orange, brick, cobbles, weave, hammered, waves, map };

/// "orange", "brick" … "waves": the names of those that are functions.
std::span<const std::string_view> builtinHeightNames();

/// How deep and how dense a surface is by itself.
struct HeightSize {
  float scale;      ///< Material::height_scale
  float frequency;  ///< Material::height_frequency
};
HeightSize ownSize(HeightKind kind);

/// A tile of one of them.
///
/// kind    not none, not map
/// side    texels across and down
/// cost    512² in 20 ms to 60 ms on two cores
Image builtinHeights(HeightKind kind, int side);

}  // namespace mirrorball
