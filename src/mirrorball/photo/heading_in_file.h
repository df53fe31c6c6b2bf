#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/file/compass_heading.h"

namespace mirrorball {

/// The compass heading that a picture states: that of a Photo Sphere in XMP, which may lie in any format, else the one
/// of a JPEG's EXIF. EXIF's counts as absent where it cannot be an angle; a Photo Sphere's heading, and the tilt beside
/// it, does not, since without it north would be another one.
///
/// bytes    of a file, or those at its beginning
/// errors   bad_file: a field of the Photo Sphere's heading is not a number of degrees in its range; names both
/// cost     a few passes over the bytes, whatever they are
/// from     Google, Photo Sphere XMP Metadata; Exif 3.0 (CIPA DC-008-2023), GPSImgDirection and GPSImgDirectionRef
Result<std::optional<CompassHeading>> headingIn(std::span<const std::uint8_t> bytes);

/// The heading that a file states, of which the first and the last MiB are read: there formats have their metadata.
///
/// returns  nothing, too, where the path does not lead to a file
/// errors   io; as headingIn's. Without the file's name
Result<std::optional<CompassHeading>> headingInFile(const std::filesystem::path& path);

/// The heading that a file states, where it cannot be done without.
///
/// errors   not_found: it states none; as headingInFile's
Result<CompassHeading> requiredHeading(const std::filesystem::path& path);

}  // namespace mirrorball
