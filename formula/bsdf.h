#pragma once

/// Fresnel, Snell, microfacets, lobes and their table. How these files are read: formula/formula.h.

#include "formula/constants.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/microfacet.glsl"
#include "formula/optics.glsl"
#include "formula/reflection_lobe.glsl"
//
#include "formula/brdf_table.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
