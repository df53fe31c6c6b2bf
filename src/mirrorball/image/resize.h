#pragma once

#include <glm/vec2.hpp>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// An image in another size: along a side that gets shorter each texel is the mean of what it covers, along one that
/// gets longer it lies on the straight line between its neighbours. The mean of an image stays where both get shorter.
///
/// image    any channels, of numbers that may be averaged (linear light), at least one texel
/// size     at least 1 × 1 texels
/// cost     3 to 5 ns a sample that is read, on one core
Image resized(const Image& image, glm::ivec2 size);

}  // namespace mirrorball
