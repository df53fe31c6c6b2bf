#pragma once

/// Colour: luminance, transfer curves, tone maps, dithering. How these files are read: formula/formula.h.

#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/color.glsl"
//
#include "formula/dither.glsl"
//
#include "formula/wavelength.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
