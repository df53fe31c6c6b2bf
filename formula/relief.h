#pragma once

/// Height fields: their slopes, normals and horizons. How these files are read: formula/formula.h.

#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/relief/occlusion.glsl"
#include "formula/relief/slope.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
