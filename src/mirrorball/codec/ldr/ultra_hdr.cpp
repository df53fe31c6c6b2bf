#include "mirrorball/codec/ldr/ultra_hdr.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/ldr/gain_map_metadata.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"

namespace mirrorball {
namespace {

using FileBytes = std::span<const std::uint8_t>;

std::string_view textIn(FileBytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// What a JPEG's header says of gain maps.
struct GainMapWords {
  FileBytes iso;
  std::string_view xmp;

  bool areThere() const { return !iso.empty() || !xmp.empty(); }
};

GainMapWords gainMapWords(const JpegHeader& header) {
  GainMapWords words;
  for (const JpegSegment& segment : header.segments) {
    if (const FileBytes iso = segment.behind(kApp2, kIsoGainMapName); !iso.empty()) words.iso = iso;
    const std::string_view xmp = textIn(segment.behind(kApp1, kXmpName));
    if (!xmp.empty() && speaksOfGainMap(xmp)) words.xmp = xmp;
  }
  return words;
}

/// Where the next JPEG begins, from `at` on; the number of bytes where there is none.
std::size_t nextJpeg(FileBytes bytes, std::size_t at) {
  constexpr std::array<std::uint8_t, 3> kBegin{0xff, 0xd8, 0xff};
  const auto found =
      std::search(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end(), kBegin.begin(), kBegin.end());
  return static_cast<std::size_t>(found - bytes.begin());
}

}  // namespace

Result<std::optional<GainMapPart>> findGainMap(FileBytes bytes) {
  if (!gainMapWords(jpegHeader(bytes)).areThere()) return std::nullopt;
  for (std::size_t at = nextJpeg(bytes, endOfJpeg(bytes)); at < bytes.size();) {
    const FileBytes jpeg = bytes.subspan(at);
    const JpegHeader header = jpegHeader(jpeg);
    if (const GainMapWords words = gainMapWords(header); words.areThere()) {
      MIRRORBALL_TRY(map, words.iso.empty() ? readGainMapXmp(words.xmp) : readGainMapIso(words.iso));
      return GainMapPart{jpeg, map};
    }
    at = nextJpeg(bytes, at + header.end);
  }
  return GainMapPart{};
}

namespace {

Bytes named(std::string_view name, FileBytes data) {
  Bytes bytes(name.begin(), name.end());
  bytes.insert(bytes.end(), data.begin(), data.end());
  return bytes;
}

Bytes named(std::string_view name, std::string_view text) {
  return named(name, FileBytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void append(Bytes& bytes, const Bytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

void putBig(Bytes& bytes, std::size_t number, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

constexpr std::string_view kMpfName("MPF\0", 4);

/// MPF's index of two pictures: a directory of TIFF with its version, their number and a row for each.
///
/// map_at   from the directory's own beginning
Bytes pictureIndex(std::size_t picture_bytes, std::size_t map_bytes, std::size_t map_at) {
  constexpr std::size_t kDirectory = 8;
  constexpr std::size_t kEntry = 12;
  constexpr std::size_t kRows = kDirectory + 2 + 3 * kEntry + 4;
  constexpr std::size_t kRow = 16;
  constexpr std::size_t kUndefined = 7, kLong = 4;
  Bytes bytes{'M', 'M', 0, 42};
  putBig(bytes, kDirectory, 4);
  putBig(bytes, 3, 2);
  const auto entry = [&](std::size_t tag, std::size_t type, std::size_t count) {
    putBig(bytes, tag, 2);
    putBig(bytes, type, 2);
    putBig(bytes, count, 4);
  };
  entry(0xb000, kUndefined, 4);
  append(bytes, {'0', '1', '0', '0'});
  entry(0xb001, kLong, 1);
  putBig(bytes, 2, 4);
  entry(0xb002, kUndefined, 2 * kRow);
  putBig(bytes, kRows, 4);
  putBig(bytes, 0, 4);                        // no further directory
  constexpr std::size_t kPrimary = 0x030000;  // "baseline MP primary image"; the other's kind is undefined
  for (const std::size_t number :
       {kPrimary, picture_bytes, std::size_t{0}, std::size_t{0}, std::size_t{0}, map_bytes, map_at, std::size_t{0}})
    putBig(bytes, number, 4);
  return bytes;
}

/// A JPEG with further segments in its header.
Bytes withSegments(const Bytes& jpeg, const Bytes& segments) {
  Bytes bytes = jpeg;
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(behindJfif(jpeg)), segments.begin(), segments.end());
  return bytes;
}

}  // namespace

Bytes joinedUltraHdr(const Bytes& picture, const Bytes& map, const GainMap& gain_map) {
  Bytes of_map = jpegSegment(kApp1, named(kXmpName, gainMapXmp(gain_map)));
  append(of_map, jpegSegment(kApp2, named(kIsoGainMapName, gainMapIso(gain_map))));
  const Bytes second = withSegments(map, of_map);

  Bytes segments = jpegSegment(kApp1, named(kXmpName, gainMapContainerXmp(second.size())));
  append(segments, jpegSegment(kApp2, named(kIsoGainMapName, gainMapIsoVersion())));
  // The index counts from its own beginning, and it comes last of these.
  const std::size_t index_bytes = jpegSegment(kApp2, named(kMpfName, pictureIndex(0, 0, 0))).size();
  const std::size_t first_bytes = picture.size() + segments.size() + index_bytes;
  const std::size_t index_at = behindJfif(picture) + segments.size() + 4 + kMpfName.size();
  append(segments,
         jpegSegment(kApp2, named(kMpfName, pictureIndex(first_bytes, second.size(), first_bytes - index_at))));
  Bytes bytes = withSegments(picture, segments);
  append(bytes, second);
  return bytes;
}

}  // namespace mirrorball
