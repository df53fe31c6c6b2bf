#pragma once

/// What prefiltering is made of: harmonics, points of light, mip levels. How these files are read: formula/formula.h.

#include "formula/constants.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/prefilter/bright_light.glsl"
#include "formula/prefilter/harmonics.glsl"
#include "formula/prefilter/mip_mapping.glsl"
#include "formula/prefilter/mip_taps.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
