#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// What a camera wrote about a photograph, as far as it matters here. What it did not write is absent.
struct Exif {
  std::optional<double> exposure_time_s;
  std::optional<double> f_number;
  std::optional<double> iso;
  std::optional<double> focal_length_35mm;  ///< equivalent focal length [mm] for a diagonal of 43.27 mm
  int orientation = 1;                      ///< EXIF's number, 1 … 8: how the stored rows and columns are to be shown
};

/// Reads the EXIF segment of a JPEG. Values that no camera can mean (0, negative, not finite) count as absent, and so
/// does everything in a file without the segment or with a damaged one.
Exif readExif(std::span<const std::uint8_t> jpeg);

/// Turns a picture upright.
///
/// orientation  EXIF's number; 1 and numbers outside 1 … 8 leave the picture as it is
/// from         Exif 2.32 (CIPA DC-008), tag 274: which side of the shown picture the stored row 0 and column 0 are
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
