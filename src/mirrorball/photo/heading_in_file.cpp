#include "mirrorball/photo/heading_in_file.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/ldr/xmp_properties.h"
#include "mirrorball/photo/exif.h"

namespace mirrorball {
namespace {

constexpr std::string_view kPhotoSphere = "http://ns.google.com/photos/1.0/panorama/";

/// An angle up to `most` on either side; 0 where it is absent.
std::optional<double> readAngle(const XmpProperties& properties, std::string_view name, double most) {
  const std::vector<std::string_view> values = properties.values(name);
  if (values.empty()) return 0.0;
  const std::optional<double> angle = parseNumber(values.front());
  return angle && std::abs(*angle) <= most ? angle : std::nullopt;
}

std::optional<CompassHeading> headingInXmp(std::string_view text) {
  if (text.find(kPhotoSphere) == std::string_view::npos) return std::nullopt;
  const XmpProperties properties(text, kPhotoSphere, "GPano");
  if (properties.values("PoseHeadingDegrees").empty()) return std::nullopt;
  const auto heading = readAngle(properties, "PoseHeadingDegrees", 360.0);
  const auto pitch = readAngle(properties, "PosePitchDegrees", 90.0);
  const auto roll = readAngle(properties, "PoseRollDegrees", 180.0);
  if (!heading || !pitch || !roll) return std::nullopt;
  return CompassHeading{.heading_deg = std::fmod(*heading + 360.0, 360.0),
                        .pitch_deg = *pitch,
                        .roll_deg = *roll,
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

std::optional<CompassHeading> headingIn(std::span<const std::uint8_t> bytes) {
  auto heading = headingInXmp({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return heading ? heading : headingInExif(bytes);
}

Result<std::optional<CompassHeading>> headingInFile(const std::filesystem::path& path) {
  constexpr std::uint64_t kPart = std::uint64_t{1} << 20;
  std::error_code status;
  if (!std::filesystem::is_regular_file(path, status)) return std::nullopt;
  MIRRORBALL_TRY(file, FileReader::open(path));
  std::vector<std::uint8_t> bytes(std::min(file.size(), kPart));
  MIRRORBALL_TRY_VOID(file.readAt(0, bytes));
  auto heading = headingIn(bytes);
  if (heading || file.size() <= kPart) return heading;
  MIRRORBALL_TRY_VOID(file.readAt(file.size() - bytes.size(), bytes));
  return headingIn(bytes);
}

}  // namespace mirrorball
