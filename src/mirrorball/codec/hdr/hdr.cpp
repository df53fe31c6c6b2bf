#include "mirrorball/codec/hdr/hdr.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/hdr/hdr_lines.h"
#include "mirrorball/codec/metadata.h"

namespace mirrorball {
namespace {

struct Rgbe {
  std::array<std::uint8_t, 4> bytes;
};

Rgbe encodeTexel(glm::vec3 light) {
  constexpr float kLargest = 0x1.fep+126f;  // 255 · 2^(255 − 136)
  for (int c = 0; c < 3; ++c) light[c] = light[c] > 0.0f ? std::min(light[c], kLargest) : 0.0f;  // NaN is not above 0
  const float brightest = std::max({light.x, light.y, light.z});
  int exponent = 0;
  std::frexp(brightest, &exponent);
  // Rounding may carry the brightest mantissa to 256: then the exponent is one more.
  if (std::floor(std::ldexp(double{brightest}, 8 - exponent) + 0.5) > 255.0) ++exponent;
  if (brightest == 0.0f || exponent + 128 < 1) return {};
  const double scale = std::ldexp(1.0, 8 - exponent);
  const auto mantissa = [&](float component) { return static_cast<std::uint8_t>(double{component} * scale + 0.5); };
  return {{mantissa(light.x), mantissa(light.y), mantissa(light.z), static_cast<std::uint8_t>(exponent + 128)}};
}

/// Of primaries that count for nothing where the components are numbers.
std::string spaceStatedBy(const HdrHeader& header) {
  return statedSpace({.transfer = Transfer::linear, .primaries = header.xyz ? kCieXyz : header.primaries}, 3);
}

/// How many bytes from `at` on are the same, up to the longest run.
std::size_t runLength(std::span<const std::uint8_t> plane, std::size_t at) {
  const std::size_t max = std::min(plane.size() - at, kLongestRun);
  std::size_t count = 1;
  while (count < max && plane[at + count] == plane[at]) ++count;
  return count;
}

/// One component of a scan line: runs of at least 4 (a shorter one saves nothing between literals),
/// and literals between them.
void appendPlane(std::span<const std::uint8_t> plane, Bytes& out) {
  constexpr std::size_t kShortestRun = 4;
  std::size_t literal = 0;  // where the pending literals begin
  const auto flush = [&](std::size_t end) {
    while (literal < end) {
      const std::size_t count = std::min(end - literal, kLongestLiteral);
      out.push_back(static_cast<std::uint8_t>(count));
      out.insert(out.end(), plane.data() + literal, plane.data() + literal + count);
      literal += count;
    }
  };
  for (std::size_t at = 0; at < plane.size();) {
    const std::size_t count = runLength(plane, at);
    if (count >= kShortestRun) {
      flush(at);
      out.push_back(static_cast<std::uint8_t>(kLongestLiteral + count));
      out.push_back(plane[at]);
      literal = at + count;
    }
    at += count;
  }
  flush(plane.size());
}

Bytes encodeLine(const Image& image, int y) {
  const std::size_t length = std::size_t(image.width());
  const bool rle = length >= kShortestRle && length <= kLongestRle;
  Bytes out;
  Bytes planes(4 * length);
  for (std::size_t x = 0; x < length; ++x) {
    const Rgbe texel = encodeTexel(rgbAt(image, static_cast<int>(x), y));
    for (std::size_t plane = 0; plane < 4; ++plane)
      planes[rle ? plane * length + x : 4 * x + plane] = texel.bytes[plane];
  }
  if (!rle) return planes;
  out.reserve(4 * length + 64);
  out.assign({2, 2, static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length)});
  for (std::size_t plane = 0; plane < 4; ++plane) appendPlane(std::span(planes).subspan(plane * length, length), out);
  return out;
}

/// Numbers are the file's, whatever it says that light was multiplied by.
void leaveExposureOut(HdrHeader& header) {
  const glm::vec3 exposure = std::exchange(header.exposure, glm::vec3(1.0f));
  if (exposure == glm::vec3(1.0f)) return;
  std::string factors = formatNumber(double(exposure.r));
  if (exposure != glm::vec3(exposure.r))
    factors += ", " + formatNumber(double(exposure.g)) + ", " + formatNumber(double(exposure.b));
  header.oddities.push_back("states an exposure (" + factors +
                            "), which is not divided out of numbers: they are read as they are stored");
}

}  // namespace

bool isHdr(std::span<const std::uint8_t> bytes) { return beginsWithHdrHeader(bytes); }

Result<DecodedImage> decodeHdr(std::span<const std::uint8_t> bytes, const ImageReadOptions& options) {
  MIRRORBALL_TRY(header, parseHdrHeader(bytes));
  MIRRORBALL_TRY_VOID(checkLineBytes(header, bytes.size() - header.size));
  MIRRORBALL_TRY_VOID(checkImageMemory(header.width, header.height, 3));
  MIRRORBALL_TRY(index, indexLines(bytes, header.size, header, 0, header.lineCount(), 0));
  MIRRORBALL_TRY(remark, missingLinesRemark(header, index.starts.size(), index.new_rle_count, bytes.size()));
  if (!remark.empty()) header.oddities.push_back(std::move(remark));
  const bool is_light = options.as == ReadAs::light;
  if (!is_light) leaveExposureOut(header);
  Image image = Image::withoutValues(header.width, header.height, 3);
  decodeLines(bytes, index, header, image);
  bool is_converted = is_light && header.exposure != glm::vec3(1.0f);
  if (is_light) is_converted |= convertToRec709(image, header);
  if (!is_light) tellUnapplied(spaceStatedBy(header), header.oddities);
  return DecodedImage{.image = std::move(image),
                      .metadata = std::move(header.metadata),
                      .format = describe(header, index.form),
                      .color = is_light ? describeColor(header) : std::string(kAsStored),
                      .oddities = std::move(header.oddities),
                      .is_converted = is_converted};
}

Bytes encodeHdr(const Image& image, const Metadata& metadata, OutputPrimaries primaries) {
  std::vector<Bytes> lines(std::size_t(image.height()));
  parallelFor(lines.size(), linesPerPiece(std::size_t(image.width())), [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) lines[y] = encodeLine(image, static_cast<int>(y));
  });

  std::string header = "#?RADIANCE\n";
  for (const auto& [key, value] : metadata) header += "# " + metadataLine(key, value) + "\n";
  if (primaries != OutputPrimaries::rec709) header += primariesLine(chromaticitiesOf(primaries)) + "\n";
  header +=
      "FORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.height()) + " +X " + std::to_string(image.width()) + "\n";
  Bytes bytes(header.begin(), header.end());
  for (const Bytes& line : lines) bytes.insert(bytes.end(), line.begin(), line.end());
  return bytes;
}

}  // namespace mirrorball
