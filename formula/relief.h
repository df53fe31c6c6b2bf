#pragma once

/// Height fields: the built-in bumpy surfaces, slopes and normals, and where rays meet them. How these files are read:
/// formula/formula.h.

#include "formula/box.h"
#include "formula/constants.h"
#include "formula/grid_random.h"
#include "formula/surface.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/relief/dual.glsl"
#include "formula/relief/relief_noise.glsl"
//
#include "formula/relief/brick.glsl"
#include "formula/relief/cobbles.glsl"
#include "formula/relief/hammered.glsl"
#include "formula/relief/orange_skin.glsl"
#include "formula/relief/waves.glsl"
#include "formula/relief/weave.glsl"
//
#include "formula/relief/builtin_height.glsl"
//
#include "formula/relief/height_map.glsl"
#include "formula/relief/occlusion.glsl"
#include "formula/relief/slope.glsl"
//
#include "formula/relief/exact_search.glsl"
#include "formula/relief/horizon.glsl"
#include "formula/relief/relief_search.glsl"
//
#include "formula/relief/relief_prism.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
