#pragma once

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// The normals of a height field, in the space of its texture: x to the right, y up, z out of the surface, as glTF and
/// OpenGL have them. Programs for DirectX have y down.
///
/// heights  1 channel, in settings.scale texture widths
/// returns  3 channels, unit vectors, z ≥ 0
/// errors   non_finite (the first bad texel is named); too_large; interrupted
/// cost     4096² in 60 ms on two cores, what writing the map costs
/// from     Blinn 1978, "Simulation of wrinkled surfaces"; formula/relief/slope.glsl
Result<Image> normalsFromHeights(const Image& heights, const HeightFieldSettings& settings = {},
                                 const ProgressFunction& progress = {});

/// The slopes of a height field, (∂d/∂u, 0, ∂d/∂v), as the lecture stores them: v counts down the rows, and d, u and v
/// are in texture widths, so that 1 is 45°. With the scale 1 / width they are differences between texels.
///
/// heights  1 channel, in settings.scale texture widths
/// returns  3 channels, signed
/// errors   as normalsFromHeights'
Result<Image> derivativesFromHeights(const Image& heights, const HeightFieldSettings& settings = {},
                                     const ProgressFunction& progress = {});

}  // namespace mirrorball
