#pragma once

/// What prefiltering is made of: harmonics, points of light, mip levels. How these files are read: formula/formula.h.

#include "formula/constants.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/bright_light.glsl"
#include "formula/harmonics.glsl"
#include "formula/mip_mapping.glsl"
#include "formula/mip_taps.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
