#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// Between which texels a slope is taken (heightDifference, formula/relief/slope.glsl, whose order this is).
enum class HeightDifference {
  backward,  ///< the texel and the one before it, as the lecture has it: half a texel off
  forward,   ///< the one after it and the texel
  central,   ///< the two beside it, over two texels
  sobel,     ///< central, smoothed across: less noise of a picture's steps, less detail
};

/// What lies beyond the edges of a map.
enum class MapEdges {
  tiled,    ///< the map again
  clamped,  ///< its outermost texels, for ever
};

/// What a map's texels mean.
struct HeightFieldSettings {
  HeightDifference difference = HeightDifference::central;
  MapEdges edges = MapEdges::tiled;
  float scale = 1.0f;  ///< texture widths that a height of 1 has, up to ±1e30; below 0 heights are depths
};

/// The texel of a row or column that a place beyond its ends stands for.
///
/// place   from −length to 2 · length − 1
constexpr int texelBeyond(int place, int length, MapEdges edges) {
  if (place >= 0 && place < length) return place;
  if (edges == MapEdges::clamped) return place < 0 ? 0 : length - 1;
  return place < 0 ? place + length : place - length;
}

/// The first channel of a picture.
struct PictureHeights {
  Image heights;        ///< 1 channel
  bool is_grey = true;  ///< the other colours are the same
};
PictureHeights heightsOfPicture(Image picture);

/// Refuses heights that are no numbers.
///
/// heights  1 channel, at least one texel
/// errors   non_finite (the first bad texel is named)
Result<void> checkHeights(const Image& heights);

/// Refuses heights whose squares would not be finite.
///
/// errors   out_of_range
Result<void> checkRange(const Image& heights);

}  // namespace mirrorball
