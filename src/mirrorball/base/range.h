#pragma once

#include <algorithm>
#include <functional>
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

/// The first element of which `part`, a member or a function, is `value`; the range's end where there is none.
template <typename Range, typename Value, typename Part>
constexpr auto findBy(Range&& range, const Value& value, Part part) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](const auto& element) { return std::invoke(part, element) == value; });
}

/// Sorts by `part` of each element, a member or a function, the greatest first; equal ones stay in their order.
template <typename Range, typename Part>
void sortDownBy(Range& range, Part part) {
  std::stable_sort(std::begin(range), std::end(range),
                   [&](const auto& a, const auto& b) { return std::invoke(part, a) > std::invoke(part, b); });
}

/// The same, the least first.
template <typename Range, typename Part>
void sortUpBy(Range& range, Part part) {
  std::stable_sort(std::begin(range), std::end(range),
                   [&](const auto& a, const auto& b) { return std::invoke(part, a) < std::invoke(part, b); });
}

}  // namespace mirrorball
