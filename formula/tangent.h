#pragma once

/// Frames on a surface. How the file is read: formula/formula.h.

#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/surface/tangent.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
