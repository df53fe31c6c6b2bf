#include "mirrorball/height_field/height_field.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace mirrorball {

PictureHeights heightsOfPicture(Image picture) {
  const int channels = picture.channels();
  if (channels == 1) return {std::move(picture)};
  PictureHeights result{Image::withoutValues(picture.width(), picture.height(), 1)};
  const float* from = picture.samples().data();
  for (float& height : result.heights.samples()) {
    height = from[0];
    if (channels >= 3 && (from[1] != from[0] || from[2] != from[0])) result.is_grey = false;
    from += channels;
  }
  return result;
}

Result<void> checkHeights(const Image& heights) {
  assert(!heights.empty() && heights.channels() == 1);
  if (const NonFinite bad = findNonFinite(heights); bad.count > 0) return fail(ErrorCode::non_finite, textOf(bad));
  return {};
}

Result<void> checkRange(const Image& heights) {
  constexpr float kLimit = 1e15f;
  const auto [low, high] = std::minmax_element(heights.samples().begin(), heights.samples().end());
  if (std::max(*high, -*low) <= kLimit) return {};
  return fail(ErrorCode::out_of_range, "has heights beyond 1e15, more than can be computed with; use a smaller unit");
}

}  // namespace mirrorball
