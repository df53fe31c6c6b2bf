#pragma once

/// Direction ↔ position in a map, for every projection. How these files are read: formula/formula.h.

#include "formula/constants.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/cube.glsl"
#include "formula/equiangular_cube.glsl"
#include "formula/mirror_ball.glsl"
#include "formula/octahedral.glsl"
#include "formula/paraboloid.glsl"
#include "formula/projection.glsl"
#include "formula/sphere_map.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
