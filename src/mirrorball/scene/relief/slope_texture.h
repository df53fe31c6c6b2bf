#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// Slopes as they are meant, of the numbers of a picture: of `surface --to derivative`.
///
/// numbers     at least one texel
/// is_encoded  they are ½ + ½ slope; where the most frequent texel has slopes of 128 of 255, that stands for 0
/// returns     3 channels (∂d/∂u, 0, ∂d/∂v), of at most 10⁴: steeper than 89.99° is nothing that a picture shows
/// errors      bad_shape: fewer than three channels; non_finite (the first bad texel is named)
Result<Image> slopesOfPicture(const Image& numbers, bool is_encoded);

}  // namespace mirrorball
