#pragma once

// What the rows of parity's cases are written with: the stand-ins for samplers and surfaces, PARITY, tolerances.

#include "formula/formula.h"
#include "parity/parity_case.h"

// As in the formulas: a struct from its fields, in C++ and in GLSL. It stays defined for the rows.
#define MAKE(Type) makeAggregate<Type>

namespace mirrorball::formula {

#define FN inline
#include "parity/smooth_cube.glsl"
#include "parity/smooth_map.glsl"
//
#include "parity/small_tree.glsl"
#include "parity/test_ground.glsl"
#include "parity/test_media.glsl"
#include "parity/test_prism.glsl"
#include "parity/test_surface.glsl"
#undef FN

}  // namespace mirrorball::formula

// One row a formula: its name, the domain, the tolerance, and an expression that C++ compiles here
// and a shader compiles as text.
#define PARITY(function, domain, tolerance, ...)                                                                      \
  mirrorball::parity::Case {                                                                                          \
#function, mirrorball::parity::Domain::domain, tolerance, #__VA_ARGS__,                                           \
        []([[maybe_unused]] vec4 p, [[maybe_unused]] vec4 q, [[maybe_unused]] vec4 r) -> vec4 { return __VA_ARGS__; } \
  }

namespace mirrorball::parity {

using namespace formula;

// Whole numbers, choices, and sums and products that a power of two scales.
inline constexpr float kExact = 0.0f;
// Some additions, multiplications, divisions and square roots: a few units in the last place, since
// a shader may fuse or reorder them and divide by way of the reciprocal.
inline constexpr float kTight = 1e-5f;
// exp2, log2, pow, atan, sin: OpenGL promises little for these, and drivers take polynomials;
// Mesa's atan is off by 2e-6.
inline constexpr float kTranscendental = 5e-5f;

}  // namespace mirrorball::parity
