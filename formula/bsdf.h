#pragma once

/// Fresnel, Snell, microfacets, BSDFs, lobes and their table. How these files are read: formula/formula.h.

#include "formula/constants.h"
#include "formula/tangent.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/diffuse.glsl"
#include "formula/ggx.glsl"
#include "formula/microfacet.glsl"
#include "formula/optics.glsl"
#include "formula/phong.glsl"
#include "formula/reflection_lobe.glsl"
//
#include "formula/brdf_table.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
