#pragma once

/// Light that passes through bodies: the triangles that it meets, the bodies that it is inside of, how wide it
/// becomes. How these files are read: formula/formula.h. A sampler of words is any type with `uvec4 fetchWords(const
/// Type&, int texel)` beside it.

#include "formula/bsdf.h"
#include "formula/constants.h"
#include "formula/projection.h"
//
#include "formula/glsl_begin.inc"

namespace mirrorball::formula {
#include "formula/bodies/back_face.glsl"
#include "formula/bodies/beam.glsl"
#include "formula/bodies/media.glsl"
#include "formula/bodies/triangle_tree.glsl"
//
#include "formula/bodies/scene_surface.glsl"
}  // namespace mirrorball::formula

#include "formula/glsl_end.inc"
