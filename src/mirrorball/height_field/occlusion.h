#pragma once

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// What the texels of a height field see of the sky.
struct Occlusion {
  Image visible;       ///< 1 channel in [0, 1]: the share of an even sky's irradiance that arrives; 1 on flat ground
  Image bent_normals;  ///< 3 channels, unit: the mean direction of that light; x right, y up, z out of the surface
};

/// How much of an even sky each texel sees over the horizon of the height field around it, weighted by the cosine to
/// its own normal, and where that light comes from. A texel of a tiled map sees at least one tile to each side; beyond,
/// and beyond clamped edges, the ground is even.
///
/// In each of some azimuths the map is swept along parallel lines that visit the texels' centres; a line keeps the
/// upper hull of what it has passed, whose tangent is the horizon. Heights are interpolated where a line crosses the
/// rows or columns of texels. What a slice of the sky gives is closed (formula/relief/occlusion.glsl).
///
/// azimuths  8, 16, 32 or 64: with few, narrow gaps and towers are missed
/// errors    non_finite (the first bad texel is named); out_of_range; too_large; interrupted
/// cost      O(azimuths²) steps a texel, whatever the heights: 1024² with 32 azimuths in 4 s on two cores
/// from      Timonen and Westerholm 2010, "Scalable height field self-shadowing", for hulls along lines; Landis 2002,
///           "Production-ready global illumination", for bent normals
Result<Occlusion> occlusionOf(const Image& heights, const HeightFieldSettings& settings = {}, int azimuths = 32,
                              const ProgressFunction& progress = {});

}  // namespace mirrorball
