#pragma once

/// The numbers of a material. How the file is read: formula/formula.h.

#include "formula/constants.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/material.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
