#pragma once

/// Environments that are near: where a ray meets the surface that a map stands for, and how that looks from where the
/// map was captured. How these files are read: formula/formula.h.

#include "formula/bodies.h"
#include "formula/box.h"
#include "formula/bsdf.h"
#include "formula/constants.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/proxy/proxy_sight.glsl"
//
#include "formula/proxy/captured_sight.glsl"
#include "formula/proxy/glossy_ground.glsl"
#include "formula/proxy/proxy_mesh.glsl"
#include "formula/proxy/proxy_shape.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
