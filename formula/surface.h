#pragma once

/// What a pixel of a surface shows: bumps, textures, the light that it sees, how it answers. How these files are read:
/// formula/formula.h.

#include "formula/bsdf.h"
#include "formula/color.h"
#include "formula/grid_random.h"
#include "formula/lamp.h"
#include "formula/material.h"
#include "formula/prefilter.h"
#include "formula/projection.h"
#include "formula/sun.h"
#include "formula/tangent.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/prefilter/sampling.glsl"
#include "formula/surface/filter_kind.glsl"
#include "formula/surface/height.glsl"
#include "formula/surface/texgen.glsl"
#include "formula/surface/texture_wrap.glsl"
//
#include "formula/prefilter/blur.glsl"
#include "formula/surface/shading.glsl"
#include "formula/surface/texture_filter.glsl"
//
#include "formula/surface/clear_coat.glsl"
#include "formula/surface/lamp_shading.glsl"
#include "formula/surface/self_occlusion.glsl"
#include "formula/surface/sun_shading.glsl"
#include "formula/surface/sun_shadow.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
