#pragma once

/// Direction ↔ position in a map, for every projection. How these files are read: formula/formula.h.

#include "formula/constants.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/projection/cube.glsl"
#include "formula/projection/equiangular_cube.glsl"
#include "formula/projection/flat_cube.glsl"
#include "formula/projection/mirror_ball.glsl"
#include "formula/projection/octahedral.glsl"
#include "formula/projection/paraboloid.glsl"
#include "formula/projection/projection.glsl"
#include "formula/projection/sphere_map.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
