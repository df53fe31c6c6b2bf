#pragma once

/// Lamps: points and directions that light comes from. How the file is read: formula/formula.h.

#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/lamp.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
