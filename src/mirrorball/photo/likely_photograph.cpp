#include "mirrorball/photo/likely_photograph.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include <glm/glm.hpp>

#include "mirrorball/codec/exif.h"
#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/row_reader.h"
#include "mirrorball/environment/file/photo_sphere.h"
#include "mirrorball/environment/file/recognize.h"

namespace mirrorball {
namespace {

int bigEndian16(std::span<const std::uint8_t> bytes, std::size_t at) { return bytes[at] << 8 | bytes[at + 1]; }

/// By the first segment that begins a frame; the segments before it are skipped by their lengths.
std::optional<glm::ivec2> sizeOfJpeg(std::span<const std::uint8_t> jpeg) {
  for (std::size_t at = 2; at + 9 < jpeg.size() && jpeg[at] == 0xff;) {
    const int kind = jpeg[at + 1];
    const bool is_frame = kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc;
    if (is_frame) return glm::ivec2(bigEndian16(jpeg, at + 7), bigEndian16(jpeg, at + 5));
    at += 2 + static_cast<std::size_t>(bigEndian16(jpeg, at + 2));
  }
  return std::nullopt;
}

/// By the header, which is a PNG's first part.
std::optional<glm::ivec2> sizeOfPng(std::span<const std::uint8_t> png) {
  constexpr std::size_t kEnd = 24, kLow = 18;  // what is above 65535 is no picture that can be read
  if (png.size() < kEnd) return std::nullopt;
  return glm::ivec2(bigEndian16(png, kLow), bigEndian16(png, kLow + 4));
}

std::optional<glm::ivec2> sizeByHeader(std::span<const std::uint8_t> bytes) {
  if (isJpeg(bytes)) return sizeOfJpeg(bytes);
  return isPng(bytes) ? sizeOfPng(bytes) : std::nullopt;
}

/// Whether a picture of that size is no map by its shape, nor by what its file says.
bool hasNoMap(glm::ivec2 size, const Metadata& metadata) {
  for (const auto& [key, text] : metadata)
    if (key == "envmap" || key.starts_with("mirrorball:")) return false;
  return !recognize(size.x, size.y, {});
}

bool namesCamera(const Exif& exif) {
  return exif.exposure_time_s || exif.f_number || exif.iso || exif.focal_length_35mm;
}

}  // namespace

Result<bool> isLikelyPhotograph(const std::filesystem::path& path) {
  MIRRORBALL_TRY(rows, openRows(path));
  if (rows) return hasNoMap({rows->description().width, rows->description().height}, rows->description().metadata);
  MIRRORBALL_TRY(bytes, readImageFile(path));
  if (photoSphereIn(bytes)) return false;
  if (auto size = sizeByHeader(bytes)) {
    const Exif exif = readJpegExif(bytes);
    if (exif.orientation > 4) std::swap(size->x, size->y);  // rows are shown as columns
    const auto recognition = recognize(size->x, size->y, {});
    if (recognition && recognition->form.projection == Projection::equirect) return false;
    if (namesCamera(exif)) return true;
    if (recognition) return false;
  }
  MIRRORBALL_TRY(decoded, withName(path.string(), decodeImage(bytes)));
  return hasNoMap({decoded.image.width(), decoded.image.height()}, decoded.metadata);
}

}  // namespace mirrorball
