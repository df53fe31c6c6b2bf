#pragma once

/// The numbers that several formulas share. How these files are read: formula/formula.h.

#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/constants.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
