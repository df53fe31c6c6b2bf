#pragma once

#include <cstddef>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// How many of a map's values are so large; alpha is none of them.
struct ValueCounts {
  std::size_t all = 0;
  std::size_t lit = 0;
  std::size_t clear = 0;       ///< half floats hold all their digits of what is eight times darker too
  std::size_t too_bright = 0;  ///< sums over the whole sphere would not be finite floats

  void add(const Image& image);
  void add(const ValueCounts& other);

  /// Whether half floats hold few digits of nearly all that is lit.
  bool areTooDarkForHalves() const { return lit > 0 && 100 * clear < all; }
};

}  // namespace mirrorball
