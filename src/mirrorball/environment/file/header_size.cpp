#include "mirrorball/environment/file/header_size.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mirrorball/codec/ldr/jpeg_segments.h"
#include "mirrorball/codec/row_reader.h"
#include "mirrorball/environment/file/photo_sphere.h"

namespace mirrorball {
namespace {

int bigEndian(std::span<const std::uint8_t> bytes) {
  std::uint32_t number = 0;
  for (const std::uint8_t byte : bytes) number = number << 8 | byte;
  return static_cast<int>(std::min(number, std::uint32_t{1} << 30));
}

/// from     PNG 1.2, 11.2.2 IHDR
std::optional<glm::ivec2> sizeInPng(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  constexpr std::size_t kWidth = 16, kEnd = 24;
  if (bytes.size() < kEnd || !std::equal(kSignature.begin(), kSignature.end(), bytes.begin())) return std::nullopt;
  return glm::ivec2(bigEndian(bytes.subspan(kWidth, 4)), bigEndian(bytes.subspan(kWidth + 4, 4)));
}

/// from     ITU-T T.81, B.2.2: the frame header
std::optional<glm::ivec2> sizeInJpeg(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 2 || bytes[0] != 0xff || bytes[1] != 0xd8) return std::nullopt;
  for (const JpegSegment& segment : jpegHeader(bytes).segments) {
    const bool is_table = segment.marker == 0xc4 || segment.marker == 0xc8 || segment.marker == 0xcc;
    if (segment.marker < 0xc0 || segment.marker > 0xcf || is_table || segment.data.size() < 5) continue;
    return glm::ivec2(bigEndian(segment.data.subspan(3, 2)), bigEndian(segment.data.subspan(1, 2)));
  }
  return std::nullopt;
}

}  // namespace

std::optional<glm::ivec2> sizeInHeader(const std::filesystem::path& path) {
  const auto bytes = readEnds(path);
  if (!bytes) return std::nullopt;
  if (const auto size = sizeInPng(*bytes)) return size;
  if (const auto size = sizeInJpeg(*bytes)) return size;
  const auto rows = openRows(path);
  if (!rows || !*rows) return std::nullopt;
  return glm::ivec2((*rows)->description().width, (*rows)->description().height);
}

}  // namespace mirrorball
