#pragma once

#include <cstdint>
#include <optional>
#include <span>

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

}  // namespace mirrorball
