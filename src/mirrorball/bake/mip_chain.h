#pragma once

#include "mirrorball/environment/environment_map.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// Halves a cube again and again: each texel of a level is the mean of the texels that it covers, weighted by solid
/// angle (a plain 2 × 2 box gives a face's centre half and its corner 2.7 times its due).
///
/// cube     a map of projection cube, of any size
/// returns  levels from the cube itself down to 1², each half the side of the one before, rounded down as OpenGL does;
///          three channels
/// cost     4/3 of the cube's texels
ImageSet mipChain(const EnvironmentMap& cube);

}  // namespace mirrorball
