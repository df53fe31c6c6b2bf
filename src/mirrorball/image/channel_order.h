#pragma once

#include <utility>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// Exchanges the first and the third channel of an image that has them.
inline void swapRedAndBlue(Image& image) {
  if (image.channels() < 3) return;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) std::swap(image.texel(x, y)[0], image.texel(x, y)[2]);
}

}  // namespace mirrorball
