#pragma once

/// Height fields on surfaces: where rays meet them. How these files are read: formula/formula.h.

#include "formula/surface.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/relief/height_map.glsl"
//
#include "formula/relief/exact_search.glsl"
#include "formula/relief/relief_search.glsl"
//
#include "formula/relief/relief_prism.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
