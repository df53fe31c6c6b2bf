#pragma once

/// Every equation of the subject, as C++: the same files that are joined into the shaders (gl/shader_source.h),
/// read through a prelude over GLM. How the files are written so that both sides take them is told in
/// docs/architecture.md, "Formula once".

#include <glm/glm.hpp>

namespace mirrorball::formula {

using namespace glm;  // GLSL's names for vectors and functions, inside this namespace only

// What GLSL spells otherwise. A cube sampler is any type with `vec4 sampleLod(const Type&, vec3, float)` beside it.
#define FN inline
#define CUBE_SAMPLER const auto&

#include "formula/constants.glsl"
//
#include "formula/bright_light.glsl"
#include "formula/color.glsl"
#include "formula/cube.glsl"
#include "formula/equiangular_cube.glsl"
#include "formula/harmonics.glsl"
#include "formula/height.glsl"
#include "formula/microfacet.glsl"
#include "formula/mip_mapping.glsl"
#include "formula/mip_taps.glsl"
#include "formula/mirror_ball.glsl"
#include "formula/octahedral.glsl"
#include "formula/optics.glsl"
#include "formula/paraboloid.glsl"
#include "formula/projection.glsl"
#include "formula/reflection_lobe.glsl"
#include "formula/sampling.glsl"
#include "formula/sky.glsl"
#include "formula/sphere_map.glsl"
#include "formula/tangent.glsl"
//
#include "formula/blur.glsl"
#include "formula/brdf_table.glsl"
#include "formula/shading.glsl"

#undef FN
#undef CUBE_SAMPLER

}  // namespace mirrorball::formula
