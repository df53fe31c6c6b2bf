#pragma once

/// The built-in sky and the ground under it. How these files are read: formula/formula.h.

#include "formula/color.h"
#include "formula/constants.h"
#include "formula/grid_random.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/sky/ground.glsl"
#include "formula/sky/sky.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
