#pragma once

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// The height field whose normals are nearest to these: the least Σ (D_u h − p)² + (D_v h − q)² over all texels, where
/// D are the differences that the settings name and (p, q) the slopes of the normals. With the differences and edges by
/// which a normal map was made its heights come back, but for their mean and for what no difference sees: central ones
/// and Sobel's miss a checkerboard, and waves that are nearly one come back damped.
///
/// The sum's gradient is D_uᵀ D_u h + D_vᵀ D_v h = D_uᵀ p + D_vᵀ q, and symmetric convolutions are products for the
/// functions of MapTransform: the right side is summed up texel by texel, transformed, divided, transformed back.
///
/// normals  at least 3 channels: x right, y up, z out of the surface; of any length
/// returns  1 channel, mean 0, for settings.scale; of all such fields the flattest
/// errors   non_finite, out_of_range (the first bad texel is named: NaN, or a normal that does not point out of the
///          surface); bad_shape (a scale of 0); too_large; interrupted
/// cost     two Fourier transforms of the map: 4096² in 2 s on two cores
/// from     Frankot and Chellappa 1988, "A method for enforcing integrability in shape from shading algorithms", for
///          the method; Simchony, Chellappa and Shao 1990, "Direct analytical methods for solving Poisson equations in
///          computer vision problems", for differences instead of derivatives, and for cosines
Result<Image> heightsFromNormals(const Image& normals, const HeightFieldSettings& settings = {},
                                 const ProgressFunction& progress = {});

}  // namespace mirrorball
