#pragma once

#include <optional>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// The side of SSIM's window [pixels].
inline constexpr int kSsimWindow = 11;

/// Mean structural similarity of two pictures, by their luma (Rec. 709's weights on encoded values): over all places
/// where the window of 11 × 11 pixels, a Gaussian of σ = 1.5, lies inside.
///
/// a, b      3 channels or 1 of values encoded for a display, in [0, 1]; of one size
/// returns   at most 1, which is for equal pictures; nothing where a side is shorter than the window. Symmetric
/// errors    interrupted
/// cost      about 0.04 µs a pixel on one core; bit-identical for any number of threads
/// from      Wang et al. 2004, "Image Quality Assessment: From Error Visibility to Structural Similarity", eq. 13, with
///           K1 = 0.01 and K2 = 0.03
Result<std::optional<double>> structuralSimilarity(const Image& a, const Image& b,
                                                   const ProgressFunction& progress = {});

}  // namespace mirrorball
