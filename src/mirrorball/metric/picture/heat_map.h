#pragma once

#include "mirrorball/image/image.h"

namespace mirrorball {

/// A picture of signed differences: blue where they are below 0, red above, nearly white where there is none.
///
/// difference  one channel
/// scale       the difference that has the full colour, above 0; more have it too
/// returns     3 channels, encoded
Image8 signedHeatMap(const Image& difference, float scale);

/// The scale that shows nearly all of an image: what 99 % of the pixels that differ by 1/255 or more do not exceed
/// (where none does, of all that differ), rounded up to 1, 2 or 5 times a power of ten. 1 where no pixel differs.
float usualScale(const Image& difference);

/// A picture of FLIP's map: from nearly black, 0, to light yellow, 1.
///
/// flip     one channel in [0, 1]
Image8 flipHeatMap(const Image& flip);

}  // namespace mirrorball
