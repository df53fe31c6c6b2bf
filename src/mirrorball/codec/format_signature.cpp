#include "mirrorball/codec/format_signature.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "mirrorball/codec/byte_order.h"

namespace mirrorball {

using Span = std::span<const std::uint8_t>;

namespace {

bool hasLetters(Span bytes, std::size_t at, std::string_view letters) {
  return bytes.size() >= at + letters.size() &&
         std::equal(letters.begin(), letters.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char letter, std::uint8_t byte) { return static_cast<std::uint8_t>(letter) == byte; });
}

}  // namespace

bool isExr(Span bytes) {
  constexpr std::array<std::uint8_t, 4> kMagic{0x76, 0x2f, 0x31, 0x01};
  return bytes.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

bool isJpeg(Span bytes) { return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff; }

std::optional<std::size_t> beginOfJpeg(Span bytes) {
  constexpr std::size_t kMostBefore = 64;
  constexpr std::uint8_t kFirstMarker = 0xc0;  // of those that have a segment
  for (std::size_t at = 0; at <= kMostBefore && at + 3 < bytes.size(); ++at)
    if (isJpeg(bytes.subspan(at)) && bytes[at + 3] >= kFirstMarker && bytes[at + 3] != 0xff) return at;
  return isJpeg(bytes) ? std::optional<std::size_t>(0) : std::nullopt;
}

bool isPng(Span bytes) {
  constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  return bytes.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

bool isTiff(Span bytes) {
  constexpr std::uint16_t kClassic = 42;
  constexpr std::uint16_t kBigTiff = 43;
  if (bytes.size() < 4) return false;
  const bool is_little = bytes[0] == 'I' && bytes[1] == 'I';
  const bool is_big = bytes[0] == 'M' && bytes[1] == 'M';
  const std::uint16_t version = is_little ? littleU16(&bytes[2]) : bigU16(&bytes[2]);
  return (is_little || is_big) && (version == kClassic || version == kBigTiff);
}

bool isWebp(Span bytes) { return hasLetters(bytes, 0, "RIFF") && hasLetters(bytes, 8, "WEBP"); }

bool isAvif(Span bytes) {
  if (!hasLetters(bytes, 4, "ftyp")) return false;
  const std::size_t size = std::min<std::size_t>(bigU32(bytes.data()), bytes.size());
  constexpr std::size_t kMajor = 8;
  constexpr std::size_t kVersion = 12;  // between the major kind and the others
  for (std::size_t at = kMajor; at + 4 <= size; at += 4)
    if (at != kVersion && (hasLetters(bytes, at, "avif") || hasLetters(bytes, at, "avis"))) return true;
  return false;
}

bool isJxl(Span bytes) {
  using namespace std::string_view_literals;
  return hasLetters(bytes, 0, "\xff\x0a"sv) || hasLetters(bytes, 0, "\0\0\0\x0cJXL \r\n\x87\n"sv);
}

}  // namespace mirrorball
