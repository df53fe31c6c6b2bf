#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include <glm/common.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// What the formats have in common whose files may hold a part of a larger picture (PictureWindow).

/// Refuses a larger picture that no file of that size is for, before its memory is taken.
///
/// source      PictureWindow's
/// file_size   in bytes
/// errors      bad_file; too_large
Result<void> checkWholePicture(long long width, long long height, const std::string& source, std::uint64_t file_size);

/// The remark on a file that holds such a part: DecodedImage::oddities.
std::string windowText(const PictureWindow& window);

/// The remark where the part and the larger picture have no texel in common, which nobody can mean: the part is the
/// picture.
///
/// source   PictureWindow's
std::string noTexelText(const std::string& source);

/// The larger picture with the part in its place, 0 elsewhere.
///
/// part   at the window's corner; its size counts, not the window's
template <typename Sample>
ImageOf<Sample> placedInWindow(const ImageOf<Sample>& part, const PictureWindow& window) {
  ImageOf<Sample> whole(window.whole.x, window.whole.y, part.channels());
  const glm::ivec2 size(part.width(), part.height());
  const glm::ivec2 begin = glm::max(window.corner, glm::ivec2(0));
  const glm::ivec2 end = glm::min(window.corner + size, window.whole);
  const auto samples = std::size_t(std::max(end.x - begin.x, 0)) * std::size_t(part.channels());
  for (int y = begin.y; y < end.y; ++y)
    std::copy_n(part.texel(begin.x - window.corner.x, y - window.corner.y), samples, whole.texel(begin.x, y));
  return whole;
}

}  // namespace mirrorball
