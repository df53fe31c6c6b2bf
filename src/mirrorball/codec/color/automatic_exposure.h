#pragma once

#include "mirrorball/image/image.h"

namespace mirrorball {

/// The exposure at which an image is easy to see, be it of a cellar or of a beach: the geometric mean of the luminance
/// becomes the middle grey, 0.18 (Reinhard et al. 2002, Photographic Tone Reproduction for Digital Images, equation 1).
/// Texels without light do not count, and a hundredth of all texels at most becomes brighter than 16, which `agx` shows
/// as white: otherwise a few lamps in the dark would be exposed for the dark.
///
/// light    linear, 3 or 4 channels
/// returns  stops, within ±30; 0 of an image without light
/// cost     some 20 ns a texel
float automaticExposure(const Image& light);

}  // namespace mirrorball
