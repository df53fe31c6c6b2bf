#pragma once

/// Fresnel, Snell, microfacets, BSDFs, lobes and their table. How these files are read: formula/formula.h.

#include "formula/color.h"
#include "formula/constants.h"
#include "formula/tangent.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/bsdf/diffuse.glsl"
#include "formula/bsdf/ggx.glsl"
#include "formula/bsdf/microfacet.glsl"
#include "formula/bsdf/optics.glsl"
#include "formula/bsdf/phong.glsl"
#include "formula/bsdf/reflection_lobe.glsl"
//
#include "formula/bsdf/brdf_table.glsl"
#include "formula/bsdf/charlie.glsl"
#include "formula/bsdf/lobe_row.glsl"
#include "formula/bsdf/stretched_lobe.glsl"
#include "formula/bsdf/thin_film.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
