#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/file/compass_heading.h"

namespace mirrorball {

/// The fields that a heading is looked for in, for messages.
inline constexpr const char* kHeadingFields = "GPano:PoseHeadingDegrees in XMP, GPSImgDirection in EXIF";

/// The compass heading that a picture states: that of a Photo Sphere in XMP, which may lie in any format, else the one
/// of a JPEG's EXIF. What cannot be such an angle counts as absent.
///
/// bytes    of a file, or those at its beginning
/// from     Google, Photo Sphere XMP Metadata; Exif 3.0 (CIPA DC-008-2023), GPSImgDirection and GPSImgDirectionRef
std::optional<CompassHeading> headingIn(std::span<const std::uint8_t> bytes);

/// The heading that a file states, of which the first and the last MiB are read: there formats have their metadata.
///
/// returns  nothing, too, where the path does not lead to a file
/// errors   io
Result<std::optional<CompassHeading>> headingInFile(const std::filesystem::path& path);

}  // namespace mirrorball
