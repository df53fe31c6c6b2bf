#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace mirrorball {

/// The EXIF values of a photograph that are used here. Missing values are absent.
struct Exif {
  std::optional<double> exposure_time_s;
  std::optional<double> f_number;
  std::optional<double> iso;
  std::optional<double> focal_length_35mm;    ///< equivalent focal length [mm] for a diagonal of 43.27 mm
  std::optional<double> image_direction_deg;  ///< where the camera looked: clockwise from north, 0 … 360
  bool is_direction_magnetic = false;         ///< from the magnetic pole
  int orientation = 1;  ///< EXIF's number, 1 … 8: how the stored rows and columns must be turned
};

/// Reads the EXIF segment of a JPEG. Impossible values (0, negative, not finite) count as absent. So do all values if
/// the segment is missing or damaged.
Exif readExif(std::span<const std::uint8_t> jpeg);

}  // namespace mirrorball
