#include "mirrorball/codec/ldr/jpeg_segments.h"

#include <algorithm>

#include "mirrorball/codec/byte_order.h"

namespace mirrorball {
namespace {

using JpegBytes = std::span<const std::uint8_t>;

constexpr std::uint8_t kEndOfImage = 0xd9;
constexpr std::uint8_t kStartOfScan = 0xda;
constexpr std::uint8_t kNumberOfLines = 0xdc;
constexpr std::uint8_t kJfif = 0xe0;
constexpr std::size_t kStart = 2;  // the marker that a JPEG begins with

/// Markers without a length: a stuffed 0, TEM, and those that restart a decoder.
constexpr bool standsAlone(std::uint8_t marker) {
  return marker == 0x00 || marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
}

/// SOF0 to SOF15, between which stand DHT, JPG and DAC.
constexpr bool beginsFrame(std::uint8_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

/// Where the next marker's second byte stands, from `at` on; the number of bytes where there is none.
std::size_t nextMarker(JpegBytes jpeg, std::size_t at) {
  const auto begin = jpeg.begin() + static_cast<std::ptrdiff_t>(std::min(at, jpeg.size()));
  const auto first = std::find(begin, jpeg.end(), std::uint8_t{0xff});
  const auto code = std::find_if(first, jpeg.end(), [](std::uint8_t byte) { return byte != 0xff; });
  return static_cast<std::size_t>(code - jpeg.begin());
}

/// The data of the segment whose marker's second byte is there; of no bytes where it is cut short.
JpegBytes dataAt(JpegBytes jpeg, std::size_t marker) {
  const JpegBytes rest = jpeg.subspan(marker + 1);
  const std::size_t size = rest.size() < 2 ? 0 : bigU16(rest.data());
  return size < 2 || size > rest.size() ? JpegBytes() : rest.subspan(2, size - 2);
}

}  // namespace

JpegBytes JpegSegment::behind(std::uint8_t its_marker, std::string_view name) const {
  if (marker != its_marker || data.size() < name.size() || !std::equal(name.begin(), name.end(), data.begin()))
    return {};
  return data.subspan(name.size());
}

JpegHeader jpegHeader(JpegBytes jpeg) {
  JpegHeader header{{}, std::min(kStart, jpeg.size())};
  for (;;) {
    const std::size_t at = nextMarker(jpeg, header.end);
    if (at >= jpeg.size()) return header;
    header.end = at + 1;
    if (standsAlone(jpeg[at])) continue;
    const JpegBytes data = dataAt(jpeg, at);
    if (jpeg[at] == kEndOfImage || data.empty()) return header;
    header.end = static_cast<std::size_t>(data.data() - jpeg.data()) + data.size();
    if (jpeg[at] == kStartOfScan) return header;
    header.segments.push_back({jpeg[at], data});
  }
}

JpegBytes frameHeader(const JpegHeader& header) {
  constexpr std::size_t kFrameSize = 6;  // of its fields before those of the components
  const auto frame = std::find_if(header.segments.begin(), header.segments.end(), [](const JpegSegment& segment) {
    return beginsFrame(segment.marker) && segment.data.size() >= kFrameSize;
  });
  return frame == header.segments.end() ? JpegBytes() : frame->data;
}

std::size_t endOfJpeg(JpegBytes jpeg) {
  std::size_t end = jpegHeader(jpeg).end;
  for (;;) {
    const std::size_t at = nextMarker(jpeg, end);
    if (at >= jpeg.size()) return jpeg.size();
    end = at + 1;
    if (jpeg[at] == kEndOfImage) return end;
    // Tables may stand between scans; the bytes of a scan go on to the next marker that has a length.
    if (!standsAlone(jpeg[at])) end += 2 + dataAt(jpeg, at).size();
  }
}

std::optional<std::size_t> segmentBetweenScans(JpegBytes jpeg, std::size_t before) {
  std::optional<std::size_t> last;
  std::size_t end = jpegHeader(jpeg).end;
  for (;;) {
    const std::size_t at = nextMarker(jpeg, end);
    if (at >= jpeg.size() || at > before) return last;
    end = at + 1;
    if (standsAlone(jpeg[at])) continue;
    last = at - 1;
    end += 2 + dataAt(jpeg, at).size();
  }
}

Result<std::optional<Bytes>> withHeightInHeader(JpegBytes jpeg) {
  const JpegHeader header = jpegHeader(jpeg);
  const JpegBytes frame = frameHeader(header);
  if (frame.empty() || bigU16(&frame[kJpegFrameHeight]) != 0) return std::nullopt;
  for (std::size_t end = header.end;;) {
    const std::size_t at = nextMarker(jpeg, end);
    if (at >= jpeg.size())
      return fail(ErrorCode::bad_file,
                  "leaves its height to a DNL segment, which is not there; the file is truncated or damaged");
    end = at + 1;
    if (standsAlone(jpeg[at])) continue;
    const JpegBytes data = dataAt(jpeg, at);
    if (jpeg[at] == kNumberOfLines && data.size() == 2) {
      Bytes stated(jpeg.begin(), jpeg.end());
      std::copy(data.begin(), data.end(), stated.begin() + (frame.data() - jpeg.data()) + kJpegFrameHeight);
      return stated;
    }
    end += 2 + data.size();
  }
}

Bytes jpegSegment(std::uint8_t marker, JpegBytes data) {
  const std::size_t size = data.size() + 2;
  Bytes segment{0xff, marker, static_cast<std::uint8_t>(size >> 8), static_cast<std::uint8_t>(size)};
  segment.insert(segment.end(), data.begin(), data.end());
  return segment;
}

std::size_t behindJfif(JpegBytes jpeg) {
  const std::size_t at = nextMarker(jpeg, kStart);
  return at < jpeg.size() && jpeg[at] == kJfif ? at + 3 + dataAt(jpeg, at).size() : kStart;
}

}  // namespace mirrorball
