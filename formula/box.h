#pragma once

/// Boxes along the axes. How these files are read: formula/formula.h.

#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/box.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
