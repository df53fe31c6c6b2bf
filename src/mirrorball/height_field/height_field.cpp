#include "mirrorball/height_field/height_field.h"

#include <algorithm>
#include <cassert>

namespace mirrorball {

Result<void> checkHeights(const Image& heights) {
  assert(!heights.empty() && heights.channels() == 1);
  if (const NonFinite bad = findNonFinite(heights); bad.count > 0) return fail(ErrorCode::non_finite, textOf(bad));
  return {};
}

Result<void> checkRange(const Image& heights) {
  constexpr float kLimit = 1e15f;
  const auto [low, high] = std::ranges::minmax_element(heights.samples());
  if (std::max(*high, -*low) <= kLimit) return {};
  return fail(ErrorCode::out_of_range, "has heights beyond 1e15, more than can be computed with; use a smaller unit");
}

}  // namespace mirrorball
