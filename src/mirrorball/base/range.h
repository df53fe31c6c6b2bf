#pragma once

#include <algorithm>
#include <iterator>

namespace mirrorball {

/// Questions about whole ranges, which <algorithm> asks by two iterators; libc++ 14, which compilers for browsers have,
/// lacks std::ranges.

template <typename Range, typename Value>
constexpr bool contains(const Range& range, const Value& value) {
  return std::find(std::begin(range), std::end(range), value) != std::end(range);
}

/// Whether two ranges hold the same in the same order.
template <typename Range, typename Other>
constexpr bool areEqual(const Range& range, const Other& other) {
  return std::equal(std::begin(range), std::end(range), std::begin(other), std::end(other));
}

}  // namespace mirrorball
