#include "mirrorball/photo/heading_in_file.h"

#include <cmath>

#include "mirrorball/codec/exif.h"
#include "mirrorball/environment/file/photo_sphere.h"

namespace mirrorball {
namespace {

Result<std::optional<CompassHeading>> headingInXmp(std::span<const std::uint8_t> bytes) {
  const auto sphere = PhotoSphereFields::in(bytes);
  if (!sphere) return std::nullopt;
  MIRRORBALL_TRY(heading, sphere->angle("PoseHeadingDegrees", 360.0));
  if (!heading) return std::nullopt;
  MIRRORBALL_TRY(pitch, sphere->angle("PosePitchDegrees", 90.0));
  MIRRORBALL_TRY(roll, sphere->angle("PoseRollDegrees", 360.0));
  return CompassHeading{.heading_deg = std::fmod(*heading + 360.0, 360.0),
                        .pitch_deg = pitch.value_or(0.0),
                        .roll_deg = std::remainder(roll.value_or(0.0), 360.0),
                        .source = "GPano:PoseHeadingDegrees"};
}

std::optional<CompassHeading> headingInExif(std::span<const std::uint8_t> bytes) {
  const Exif exif = readJpegExif(bytes);
  if (!exif.image_direction_deg) return std::nullopt;
  return CompassHeading{.heading_deg = std::fmod(*exif.image_direction_deg, 360.0),
                        .is_magnetic = exif.is_direction_magnetic,
                        .source = "GPSImgDirection"};
}

}  // namespace

Result<std::optional<CompassHeading>> headingIn(std::span<const std::uint8_t> bytes) {
  MIRRORBALL_TRY(heading, headingInXmp(bytes));
  return heading ? heading : headingInExif(bytes);
}

Result<std::optional<CompassHeading>> headingInFile(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::is_regular_file(path, status)) return std::nullopt;
  MIRRORBALL_TRY(bytes, readEnds(path));
  return headingIn(bytes);
}

Result<CompassHeading> requiredHeading(const std::filesystem::path& path) {
  MIRRORBALL_TRY(heading, headingInFile(path));
  if (heading) return *heading;
  return fail(ErrorCode::not_found,
              "states no compass heading; looked for GPano:PoseHeadingDegrees in XMP, GPSImgDirection in EXIF");
}

}  // namespace mirrorball
