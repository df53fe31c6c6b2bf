#pragma once

#include <glm/glm.hpp>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// Lays an environment out in another projection.
///
/// size     a face's side, a disc's diameter, a panorama's height; at least 1
/// returns  radiance at texel centres where the source is coarser than the target; else the mean over k × k points of
///          each texel, k being the ratio of their densities (at most 16). Three channels; a disc has a fourth, alpha:
///          0 (and black) in texels whose centre lies beside it, else 1
/// errors   interrupted (when `progress` says so)
/// cost     size² · faces · k² bilinear look-ups; bit-identical for any number of threads
Result<EnvironmentMap> convert(const Environment& source, Projection to, int size,
                               const ProgressFunction& progress = {});

}  // namespace mirrorball
