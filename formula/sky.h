#pragma once

/// The built-in sky. How these files are read: formula/formula.h.

#include "formula/color.h"
#include "formula/constants.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/sky.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
