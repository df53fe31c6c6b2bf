#pragma once

#include <algorithm>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// Turns a picture upright.
///
/// orientation  the number that cameras (Exif 2.32, CIPA DC-008) and TIFF 6.0 write as tag 274: which side of the shown
///              picture the stored row 0 and column 0 are; 1 and numbers outside 1 … 8 leave the picture as it is
template <typename Sample>
ImageOf<Sample> upright(ImageOf<Sample> stored, int orientation) {
  if (orientation <= 1 || orientation > 8) return stored;
  // Of the eight: 5 to 8 exchange rows and columns, then some run backwards.
  const bool exchanged = orientation >= 5;
  const bool from_right = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
  const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
  const int width = exchanged ? stored.height() : stored.width();
  const int height = exchanged ? stored.width() : stored.height();
  ImageOf<Sample> shown(width, height, stored.channels());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int column = from_right ? width - 1 - x : x;
      const int row = from_bottom ? height - 1 - y : y;
      const Sample* source = exchanged ? stored.texel(row, column) : stored.texel(column, row);
      std::copy_n(source, stored.channels(), shown.texel(x, y));
    }
  return shown;
}

}  // namespace mirrorball
