#include "mirrorball/environment/file/picture_half.h"

#include <algorithm>
#include <cstddef>

namespace mirrorball {

std::string_view halfName(PictureHalf half) { return kPictureHalfNames[static_cast<std::size_t>(half)]; }

bool isUpperOrLower(PictureHalf half) { return half == PictureHalf::top || half == PictureHalf::bottom; }

glm::ivec2 sizeOfHalf(glm::ivec2 picture, PictureHalf half) {
  return isUpperOrLower(half) ? glm::ivec2(picture.x, picture.y / 2) : glm::ivec2(picture.x / 2, picture.y);
}

Image cutHalf(const Image& picture, PictureHalf half) {
  const glm::ivec2 whole(picture.width(), picture.height());
  const glm::ivec2 size = sizeOfHalf(whole, half);
  const bool is_second = half == PictureHalf::bottom || half == PictureHalf::right;
  const glm::ivec2 corner = is_second ? whole - size : glm::ivec2(0);
  Image eye = Image::withoutValues(size.x, size.y, picture.channels());
  for (int y = 0; y < size.y; ++y)
    std::copy_n(picture.texel(corner.x, corner.y + y), eye.row(y).size(), eye.texel(0, y));
  return eye;
}

}  // namespace mirrorball
