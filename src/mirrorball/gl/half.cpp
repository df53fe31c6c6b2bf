#include "mirrorball/gl/half.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "mirrorball/image/small_float.h"

namespace mirrorball::gl {

void halvesFromFloats(std::span<const float> floats, std::span<std::uint16_t> halves) {
  assert(floats.size() == halves.size());
  constexpr float kLargest = kLargestSmallFloat<10>;
  std::array<float, 1024> clamped;  // small enough to stay in the nearest cache
  for (std::size_t begin = 0; begin < floats.size(); begin += clamped.size()) {
    const std::size_t count = std::min(clamped.size(), floats.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const float size = std::abs(floats[begin + i]);
      clamped[i] = std::copysign(size < kLargest ? size : kLargest, floats[begin + i]);
    }
    mirrorball::halvesFromFloats(std::span(clamped).first(count), halves.subspan(begin, count));
  }
}

}  // namespace mirrorball::gl
