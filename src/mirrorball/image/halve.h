#pragma once

#include <algorithm>
#include <cassert>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// The next mip level of a texture: each texel the mean of the 2 × 2 that it covers, a last odd row or column left to
/// its neighbour as OpenGL's drivers do.
///
/// image    4 channels, at least one side longer than 1
/// srgb     the first three channels are sRGB-encoded: they are averaged as light
/// returns  max(1, side / 2) texels a side
/// cost     about 3 ns a texel of the source
Image8 halved(const Image8& image, bool srgb);

/// The same of numbers: any channels.
Image halved(const Image& image);

/// The same of anything.
///
/// average   (a, b, c, d, mean): sets a texel of the next level from the four that it covers
template <typename Half, typename Texels, typename Average>
Half halvedBy(const Texels& image, const Average& average) {
  assert(image.width() > 1 || image.height() > 1);
  Half half = Half::withoutValues(std::max(image.width() / 2, 1), std::max(image.height() / 2, 1), image.channels());
  for (int y = 0; y < half.height(); ++y) {
    const int upper = 2 * y;
    const int lower = std::min(upper + 1, image.height() - 1);
    for (int x = 0; x < half.width(); ++x) {
      const int left = 2 * x;
      const int right = std::min(left + 1, image.width() - 1);
      average(image.texel(left, upper), image.texel(right, upper), image.texel(left, lower), image.texel(right, lower),
              half.texel(x, y));
    }
  }
  return half;
}

}  // namespace mirrorball
