#include "mirrorball/height_field/height_field.h"

#include <cassert>

namespace mirrorball {

Result<void> checkHeights(const Image& heights) {
  assert(!heights.empty() && heights.channels() == 1);
  if (const NonFinite bad = findNonFinite(heights); bad.count > 0) return fail(ErrorCode::non_finite, textOf(bad));
  return {};
}

}  // namespace mirrorball
