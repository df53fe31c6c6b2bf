#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// Slopes as a renderer filters them: what a pixel averages away is kept as a variance.
struct SlopeMoments {
  /// Mip levels of 4 channels: the means of ∂h/∂u and ∂h/∂v over `unit`, and the variances of both over unit² about
  /// those means. The finest level of all has no variance. Sides are halved and rounded down; the last texel of an odd
  /// side also has the odd row or column.
  ImageSet levels;
  float unit = 1.0f;  ///< the greatest slope, so that half floats hold the small ones well
};

/// heights  1 channel
/// finest   levels that are left out: for maps of more texels than a driver takes
/// errors   non_finite; too_large
/// cost     1024² in 20 ms on two cores
/// from     Olano & Baker 2010, "LEAN mapping", whose moments these are, with variances in place of squares: half
///          floats lose small differences of squares
Result<SlopeMoments> slopeMoments(const Image& heights, MapEdges edges = MapEdges::tiled, int finest = 0);

/// The same of slopes that are there already.
///
/// slopes   3 channels, (∂d/∂u, 0, ∂d/∂v), finite and below 1e18
/// errors   too_large
Result<SlopeMoments> momentsOfSlopes(const Image& slopes, int finest = 0);

}  // namespace mirrorball
