#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/icc_profile.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/tiff/tiff_file.h"
#include "mirrorball/codec/tiff/tiff_window.h"

namespace mirrorball {

/// What the fields of a TIFF's page say, of pictures that are read.
struct TiffLayout {
  int width = 0;
  int height = 0;
  int bits = 0;  ///< of a sample: 1 to 16 or 32 as integers, 16, 32 or 64 as floats
  bool is_float = false;
  bool is_log = false;  ///< SGI's LogLuv or LogL, which libtiff hands out as floats
  int samples = 0;      ///< stored for each texel
  int colors = 0;       ///< the first of them: 1 or 3
  int alpha = -1;       ///< which sample is alpha; −1: none
  bool is_premultiplied = false;
  bool is_by_planes = false;
  bool is_white_zero = false;
  int orientation = 1;  ///< image/upright.h
  TiffWindow window;
  std::string compression;
  bool is_jpeg = false;
  std::optional<Primaries> primaries;
  IccProfile profile;  ///< whose curve means integers alone
  /// Red, green and blue of each code; empty where there is no palette.
  std::array<std::vector<std::uint16_t>, 3> palette;

  // Strips, which are as wide as the picture, or tiles.
  bool is_tiled = false;
  int strile_width = 0;
  int strile_height = 0;

  /// How many rows of each strip or tile the file holds: of those that it ends within, the whole rows where they are
  /// not compressed, else none.
  std::vector<int> rows_there = {};

  /// Which rows of the page are missing, in the order in which they are stored: those of which any part is. Nothing
  /// where none is.
  std::vector<std::uint8_t> missingRows() const;

  bool hasPalette() const { return !palette[0].empty(); }
  /// Of the image: 1, 3 or 4.
  int channels() const { return alpha >= 0 ? 4 : hasPalette() ? 3 : colors; }
  /// The sample that a channel of the image is.
  int sampleOf(int channel) const { return channel == 3 ? alpha : colors == 1 ? 0 : channel; }
  int samplesInPlane() const { return is_by_planes ? 1 : samples; }
  /// Of one plane of a strip or tile, as libtiff hands it out.
  std::uint64_t rowBytes() const {
    return (std::uint64_t(strile_width) * std::uint64_t(samplesInPlane()) * std::uint64_t(bits) + 7) / 8;
  }
  std::uint64_t strileBytes() const { return rowBytes() * std::uint64_t(strile_height); }
  int strilesAcross() const { return (width - 1) / strile_width + 1; }
  int strilesDown() const { return (height - 1) / strile_height + 1; }
  /// Of the strip or tile of that number, counted through all planes: the last strip of a plane may be lower.
  int rowsInStrile(std::uint32_t index) const {
    if (is_tiled) return strile_height;
    const std::int64_t down = index % std::uint32_t(strilesDown());
    return static_cast<int>(std::min<std::int64_t>(strile_height, height - down * strile_height));
  }
};

/// Reads the fields of the first page that is no preview, and has libtiff decode its samples as the layout says.
///
/// errors   bad_file; too_large; unsupported
Result<TiffLayout> readTiffLayout(const TiffFile& file);

}  // namespace mirrorball
