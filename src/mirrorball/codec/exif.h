#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace mirrorball {

/// The EXIF values of a picture that are used here. Missing values are absent.
struct Exif {
  std::optional<double> exposure_time_s = {};
  std::optional<double> f_number = {};
  std::optional<double> iso = {};
  std::optional<double> focal_length_35mm = {};    ///< equivalent focal length [mm] for a diagonal of 43.27 mm
  std::optional<double> image_direction_deg = {};  ///< where the camera looked: clockwise from north, 0 … 360
  bool is_direction_magnetic = false;              ///< from the magnetic pole
  int orientation = 1;  ///< EXIF's number, 1 … 8: how the stored rows and columns must be turned
};

/// Reads EXIF: a TIFF's header and directories, as PNG's chunk eXIf and WebP's EXIF hold them, with or without the
/// "Exif\0\0" that JPEG has before them. Impossible values (0, negative, not finite) count as absent, and so does
/// whatever the bytes do not reach.
///
/// cost     a pass over three directories, of at most 65535 entries each
/// from     Exif 3.0 (CIPA DC-008-2023), 4.5 (structure), 4.6 (tags); TIFF 6.0, section 2
Exif readExif(std::span<const std::uint8_t> bytes);

/// Reads the EXIF segment of a JPEG; all values are absent without one, and in other bytes than a JPEG's.
///
/// jpeg     from its first byte to the segment's end at least
Exif readJpegExif(std::span<const std::uint8_t> jpeg);

}  // namespace mirrorball
