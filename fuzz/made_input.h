#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "mirrorball/image/small_float.h"

namespace mirrorball::fuzz {

/// What is made of a fuzzer's bytes, one after the other; zeros where they end.
class MadeInput {
 public:
  MadeInput(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {}

  bool isAtEnd() const { return place_ >= bytes_.size(); }
  int byte() { return isAtEnd() ? 0 : bytes_[place_++]; }
  int upTo(int most) { return byte() % (most + 1); }

  /// A half float: small numbers that are often the same, and where the bytes say so the largest, NaN and infinity.
  float number() {
    const int low = byte();
    return floatFromHalf(static_cast<std::uint16_t>(low | byte() << 8));
  }
  float finite() {
    const float made = number();
    return std::isfinite(made) ? made : 0.0f;
  }

  /// A power of 2 in the range of float.
  float powerOfTwo() {
    const int low = byte();
    return std::ldexp(1.0f, (low < 128 ? low : low - 256) / 2);
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t place_ = 0;
};

/// What must hold of a result: else it is a finding.
inline void check(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

inline void checkFinite(std::span<const float> numbers, const char* what) {
  check(std::ranges::all_of(numbers, [](float number) { return std::isfinite(number); }), what);
}

}  // namespace mirrorball::fuzz
