#include "mirrorball/photo/heading_in_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/ldr/xmp_properties.h"
#include "mirrorball/photo/exif.h"

namespace mirrorball {
namespace {

constexpr std::string_view kPhotoSphere = "http://ns.google.com/photos/1.0/panorama/";

/// An angle up to `most` on either side [degrees]; 0 where it is absent.
///
/// errors   bad_file: it is not such an angle
Result<double> readAngle(const XmpProperties& properties, std::string_view name, double most) {
  const std::vector<std::string_view> values = properties.values(name);
  if (values.empty()) return 0.0;
  const std::optional<double> angle = parseNumber(values.front());
  if (angle && std::abs(*angle) <= most) return *angle;
  const std::string limit = formatNumber(most);
  return fail(ErrorCode::bad_file, "its GPano:" + std::string(name) + " is '" + excerpt(values.front(), 20) +
                                       "', which is not a number from -" + limit + " to " + limit +
                                       "; correct or remove that field of its XMP");
}

Result<std::optional<CompassHeading>> headingInXmp(std::string_view text) {
  if (text.find(kPhotoSphere) == std::string_view::npos) return std::nullopt;
  const XmpProperties properties(text, kPhotoSphere, "GPano");
  if (properties.values("PoseHeadingDegrees").empty()) return std::nullopt;
  MIRRORBALL_TRY(heading, readAngle(properties, "PoseHeadingDegrees", 360.0));
  MIRRORBALL_TRY(pitch, readAngle(properties, "PosePitchDegrees", 90.0));
  MIRRORBALL_TRY(roll, readAngle(properties, "PoseRollDegrees", 360.0));
  return CompassHeading{.heading_deg = std::fmod(heading + 360.0, 360.0),
                        .pitch_deg = pitch,
                        .roll_deg = std::remainder(roll, 360.0),
                        .source = "GPano:PoseHeadingDegrees"};
}

std::optional<CompassHeading> headingInExif(std::span<const std::uint8_t> bytes) {
  const Exif exif = readExif(bytes);
  if (!exif.image_direction_deg) return std::nullopt;
  return CompassHeading{.heading_deg = std::fmod(*exif.image_direction_deg, 360.0),
                        .is_magnetic = exif.is_direction_magnetic,
                        .source = "GPSImgDirection"};
}

}  // namespace

Result<std::optional<CompassHeading>> headingIn(std::span<const std::uint8_t> bytes) {
  MIRRORBALL_TRY(heading, headingInXmp({reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
  return heading ? heading : headingInExif(bytes);
}

Result<std::optional<CompassHeading>> headingInFile(const std::filesystem::path& path) {
  constexpr std::uint64_t kPart = std::uint64_t{1} << 20;
  std::error_code status;
  if (!std::filesystem::is_regular_file(path, status)) return std::nullopt;
  MIRRORBALL_TRY(file, FileReader::open(path));
  std::vector<std::uint8_t> bytes(std::min(file.size(), kPart));
  MIRRORBALL_TRY_VOID(file.readAt(0, bytes));
  MIRRORBALL_TRY(heading, headingIn(bytes));
  if (heading || file.size() <= kPart) return heading;
  MIRRORBALL_TRY_VOID(file.readAt(file.size() - bytes.size(), bytes));
  return headingIn(bytes);
}

Result<CompassHeading> requiredHeading(const std::filesystem::path& path) {
  MIRRORBALL_TRY(heading, headingInFile(path));
  if (heading) return *heading;
  return fail(ErrorCode::not_found,
              "states no compass heading; looked for GPano:PoseHeadingDegrees in XMP, GPSImgDirection in EXIF");
}

}  // namespace mirrorball
