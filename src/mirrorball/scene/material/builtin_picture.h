#pragma once

#include <span>
#include <string_view>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// "stripes": pictures that a material's textures take by name.
std::span<const std::string_view> builtinPictureNames();

/// One of them. Stripes are 32 white and 32 black ones beside each other, which go from top to bottom: what shimmers
/// where it is smaller than pixels.
///
/// name      of that list
/// returns   1024 × 1024 texels of 4 channels; a stripe is 16 texels wide
Image8 builtinPicture(std::string_view name);

}  // namespace mirrorball
