#pragma once

/// Random numbers that belong to places. How these files are read: formula/formula.h.

#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/grid_random.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
