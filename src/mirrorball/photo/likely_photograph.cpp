#include "mirrorball/photo/likely_photograph.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include <glm/glm.hpp>

#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/row_reader.h"
#include "mirrorball/environment/file/recognize.h"
#include "mirrorball/photo/exif.h"

namespace mirrorball {
namespace {

/// What is known of a picture beside its pixels.
struct PictureHead {
  glm::ivec2 size{0};
  Metadata metadata = {};
};

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

Result<PictureHead> headOf(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  MIRRORBALL_TRY(rows, openRows(path));
  if (rows) return PictureHead{{rows->description().width, rows->description().height}, rows->description().metadata};
  MIRRORBALL_TRY(decoded, withName(path.string(), decodeImage(bytes)));
  return PictureHead{{decoded.image.width(), decoded.image.height()}, std::move(decoded.metadata)};
}

bool saysWhatItIs(const Metadata& metadata) {
  for (const auto& [key, text] : metadata)
    if (key == "envmap" || key.starts_with("mirrorball:")) return true;
  return false;
}

bool namesCamera(const Exif& exif) {
  return exif.exposure_time_s || exif.f_number || exif.iso || exif.focal_length_35mm;
}

}  // namespace

Result<bool> isLikelyPhotograph(const std::filesystem::path& path) {
  MIRRORBALL_TRY(bytes, readImageFile(path));
  if (const auto size = isJpeg(bytes) ? sizeOfJpeg(bytes) : std::nullopt) {
    const auto recognition = recognize(size->x, size->y, {});
    if (recognition && recognition->form.projection == Projection::equirect) return false;
    if (namesCamera(readExif(bytes))) return true;
    if (recognition) return false;
  }
  MIRRORBALL_TRY(head, headOf(path, bytes));
  return !saysWhatItIs(head.metadata) && !recognize(head.size.x, head.size.y, {});
}

}  // namespace mirrorball
