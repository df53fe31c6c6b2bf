#pragma once

#include "mirrorball/environment/environment_map.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// How much each texel counts in the mean that is a texel of the next mip level.
enum class MipWeights {
  solid_angle,  ///< by the light that it stands for
  box,          ///< all alike: on a cube a face's centre gets half of its due and its corner 2.7 times as much
};

/// Halves a map again and again: each texel of a level is the weighted mean of the texels that it covers.
///
/// map      of any size; no projection with a disc
/// returns  levels from the map itself down to 1², each half the side of the one before, rounded down as OpenGL does;
///          three channels
/// cost     4/3 of the map's texels
ImageSet mipChain(EnvironmentMap map, MipWeights weights = MipWeights::solid_angle);

}  // namespace mirrorball
