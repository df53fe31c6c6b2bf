#pragma once

/// Suns that stand apart from an environment's map. How the file is read: formula/formula.h.

#include "formula/bsdf.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/sun.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
