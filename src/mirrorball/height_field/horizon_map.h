#pragma once

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// How steep the horizon around each texel of a height field is, in eight azimuths: what formula/relief/horizon.glsl
/// reads. Slopes grow with the scale of the heights as a whole, so one map serves every scale.
struct HorizonMap {
  /// Mip levels of two layers of 4 channels: the azimuths 0° to 135° from growing u towards growing v, and those
  /// opposite. Slopes are at least 0, and of heights in texture widths.
  ImageSet slopes;
};

/// heights   1 channel; longer sides than 512 are halved until they are not
/// errors    non_finite (the first bad texel is named); out_of_range; too_large; interrupted
/// cost      512² in 50 ms on two cores
/// from      Max 1988, "Horizon mapping: shadows for bump-mapped surfaces"; found as sweepHorizons says
Result<HorizonMap> horizonMap(const Image& heights, MapEdges edges = MapEdges::tiled,
                              const ProgressFunction& progress = {});

}  // namespace mirrorball
