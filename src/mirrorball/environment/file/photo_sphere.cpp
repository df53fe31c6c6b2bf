#include "mirrorball/environment/file/photo_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/compressed_xmp.h"

namespace mirrorball {
namespace {

constexpr std::string_view kGPano = "http://ns.google.com/photos/1.0/panorama/";
constexpr std::size_t kEnd_bytes = std::size_t{1} << 20;

/// The fields by one of which a packet is the Photo Sphere's: a JPEG may have two, one of which only names the other.
constexpr std::array<std::string_view, 7> kTellingFields{"ProjectionType",      "CroppedAreaImageWidthPixels",
                                                         "FullPanoWidthPixels", "PoseHeadingDegrees",
                                                         "PosePitchDegrees",    "PoseRollDegrees",
                                                         "StereoMode"};

constexpr std::array<std::string_view, 4> kCropFields{"CroppedAreaImageWidthPixels", "CroppedAreaImageHeightPixels",
                                                      "CroppedAreaLeftPixels", "CroppedAreaTopPixels"};

std::string nameInFile(std::string_view field) { return "its GPano:" + std::string(field); }

/// The properties of the first packet in a text that has one of the fields.
std::optional<XmpProperties> packetIn(std::string_view text) {
  constexpr std::string_view kPacketEnd = "</x:xmpmeta>";
  constexpr int kMostPackets = 3;
  for (int packet = 0; packet < kMostPackets; ++packet) {
    const std::size_t place = text.find(kGPano);
    if (place == std::string_view::npos) return std::nullopt;
    XmpProperties properties(text, kGPano, "GPano");
    const bool tells = std::any_of(kTellingFields.begin(), kTellingFields.end(),
                                   [&](std::string_view name) { return !properties.values(name).empty(); });
    if (tells) return properties;
    const std::size_t end = text.find(kPacketEnd, place);
    if (end == std::string_view::npos) return std::nullopt;
    text = text.substr(end);
  }
  return std::nullopt;
}

/// How two eyes lie in one picture, as the fields of spherical videos state it; "" where none does.
std::string stereoModeIn(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kSpherical = "http://ns.google.com/videos/1.0/spherical/";
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string_view begin = all.substr(0, kEnd_bytes);
  if (begin.find(kSpherical) == std::string_view::npos) return {};
  const std::vector<std::string_view> modes = XmpProperties(begin, kSpherical, "GSpherical").values("StereoMode");
  return modes.empty() ? std::string() : lowerCase(modes.front());
}

/// The part of the panorama that the fields state.
///
/// returns  nothing where none of the crop's is there
/// errors   bad_file; bad_shape
Result<std::optional<PanoramaArea>> statedArea(const PhotoSphereFields& fields) {
  const bool is_stated = std::any_of(kCropFields.begin(), kCropFields.end(),
                                     [&](std::string_view name) { return fields.text(name).has_value(); });
  if (!is_stated) return std::nullopt;
  PanoramaArea area;
  const std::array<std::pair<std::string_view, int*>, 6> numbers{{{"CroppedAreaImageWidthPixels", &area.size.x},
                                                                  {"CroppedAreaImageHeightPixels", &area.size.y},
                                                                  {"CroppedAreaLeftPixels", &area.corner.x},
                                                                  {"CroppedAreaTopPixels", &area.corner.y},
                                                                  {"FullPanoWidthPixels", &area.whole.x},
                                                                  {"FullPanoHeightPixels", &area.whole.y}}};
  for (const auto& [name, number] : numbers) {
    MIRRORBALL_TRY(texels, fields.texels(name));
    *number = texels;
  }
  if (const auto part = panoramaPartOfStrip(area); !part)
    return fail(part.error().code, "its GPano says that it is " + part.error().message);
  return area;
}

}  // namespace

std::optional<PhotoSphereFields> PhotoSphereFields::in(std::span<const std::uint8_t> bytes) {
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const bool is_small = all.size() <= 2 * kEnd_bytes;
  auto properties = packetIn(is_small ? all : all.substr(0, kEnd_bytes));
  if (!properties && !is_small) properties = packetIn(all.substr(all.size() - kEnd_bytes));
  if (properties) return PhotoSphereFields(std::move(*properties), nullptr);
  auto unpacked = std::make_shared<const std::string>(compressedXmp(bytes));
  properties = packetIn(*unpacked);
  if (!properties) return std::nullopt;
  return PhotoSphereFields(std::move(*properties), std::move(unpacked));
}

std::optional<std::string_view> PhotoSphereFields::text(std::string_view name) const {
  const std::vector<std::string_view> values = properties_.values(name);
  return values.empty() ? std::nullopt : std::optional(values.front());
}

Result<std::optional<double>> PhotoSphereFields::angle(std::string_view name, double most) const {
  const auto value = text(name);
  if (!value) return std::nullopt;
  const std::optional<double> angle = parseNumber(*value);
  if (angle && std::abs(*angle) <= most) return angle;
  const std::string limit = formatNumber(most);
  return fail(ErrorCode::bad_file, nameInFile(name) + " is '" + excerpt(*value, 20) +
                                       "', which is not a number from -" + limit + " to " + limit +
                                       "; correct or remove that field of its XMP");
}

Result<int> PhotoSphereFields::texels(std::string_view name) const {
  constexpr double kMost = 1 << 24;
  const auto value = text(name);
  if (!value) return fail(ErrorCode::bad_file, nameInFile(name) + " is missing, and the rest of its crop is there");
  const std::optional<double> number = parseNumber(*value);
  if (number && std::abs(*number) <= kMost) return static_cast<int>(std::lround(*number));
  return fail(ErrorCode::bad_file,
              nameInFile(name) + " is '" + excerpt(*value, 20) + "' in place of a number of texels");
}

bool PhotoSphere::isEquirectangular() const { return projection == "equirectangular"; }

bool PhotoSphere::isTilted() const {
  constexpr double kLevel_deg = 0.01;  // less than half a texel of 16K
  return std::abs(pitch_deg) > kLevel_deg || std::abs(roll_deg) > kLevel_deg;
}

std::optional<PhotoSphere> photoSphereIn(std::span<const std::uint8_t> bytes) {
  const auto fields = PhotoSphereFields::in(bytes);
  PhotoSphere sphere{.stereo = stereoModeIn(bytes)};
  if (!fields && sphere.stereo.empty()) return std::nullopt;
  if (!fields) return sphere;
  if (sphere.stereo.empty()) sphere.stereo = lowerCase(fields->text("StereoMode").value_or(""));
  sphere.projection = lowerCase(fields->text("ProjectionType").value_or(""));
  // What is wrong is left out, and reported.
  const auto unlessWrong = [&](auto result) {
    if (result) return *result;
    sphere.mistakes.push_back(result.error().message);
    return std::decay_t<decltype(*result)>{};
  };
  const auto pitch = unlessWrong(fields->angle("PosePitchDegrees", 90.0));
  const auto roll = unlessWrong(fields->angle("PoseRollDegrees", 360.0));
  if (sphere.mistakes.empty()) {
    sphere.pitch_deg = pitch.value_or(0.0);
    sphere.roll_deg = std::remainder(roll.value_or(0.0), 360.0);
  }
  auto area = statedArea(*fields);
  if (!area)
    area.error().message += ": that crop is ignored; {option:from} equirect:crop=X,Y,W,H/FULLWxFULLH says it by hand";
  sphere.area = unlessWrong(std::move(area));
  return sphere;
}

Result<Bytes> readEnds(const std::filesystem::path& path) {
  MIRRORBALL_TRY(file, FileReader::open(path));
  Bytes bytes(static_cast<std::size_t>(std::min<std::uint64_t>(file.size(), 2 * kEnd_bytes)));
  const std::span<std::uint8_t> all(bytes);
  if (file.size() <= bytes.size()) {
    MIRRORBALL_TRY_VOID(file.readAt(0, all));
    return bytes;
  }
  MIRRORBALL_TRY_VOID(file.readAt(0, all.first(kEnd_bytes)));
  MIRRORBALL_TRY_VOID(file.readAt(file.size() - kEnd_bytes, all.last(kEnd_bytes)));
  return bytes;
}

}  // namespace mirrorball
