#include "mirrorball/codec/hdr.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <vector>

#include "formula/formula.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/hdr_header.h"
#include "mirrorball/codec/metadata.h"

namespace mirrorball {
namespace {

/// New RLE exists for scan lines of these lengths only (Radiance's MINELEN and MAXELEN).
constexpr std::size_t kShortestRle = 8;
constexpr std::size_t kLongestRle = 0x7fff;

/// A code byte up to 128 counts literal bytes, one above it repeats the next byte code − 128 times.
constexpr std::size_t kLongestLiteral = 128;
constexpr std::size_t kLongestRun = 127;

/// The most texels that one byte of a real file stands for is some 3300: old RLE of a black line of
/// 65536 texels, which has 20 bytes. More is a lie that would only cost memory.
constexpr std::size_t kMostTexelsPerByte = 4096;

constexpr std::size_t kTexelsPerPiece = 1 << 15;

/// How many scan lines one piece of parallel work has.
std::size_t linesPerPiece(std::size_t line_length) { return 1 + kTexelsPerPiece / line_length; }

/// What a scan line turned out to be.
enum class LineForm { flat, old_rle, new_rle };

/// Walks over scan lines. With `kStore`, their bytes go to four planes (all R, all G, all B, all
/// E); without, only the line's end is found: that pass is cheap, and proves that the second one,
/// which takes memory and runs in parallel, will not fail.
class LineWalker {
 public:
  LineWalker(std::span<const std::uint8_t> bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  std::size_t position() const { return at_; }
  LineForm form() const { return form_; }

  /// Returns what is wrong, or nullptr.
  template <bool kStore>
  const char* walk(std::size_t length, std::uint8_t* planes) {
    if (length >= kShortestRle && length <= kLongestRle && left() >= 4 && bytes_[at_] == 2 && bytes_[at_ + 1] == 2 &&
        bytes_[at_ + 2] < 128) {
      form_ = LineForm::new_rle;
      return walkNew<kStore>(length, planes);
    }
    form_ = LineForm::flat;
    return walkOld<kStore>(length, planes);
  }

 private:
  static constexpr const char* kTruncated = "ends in the middle of a scan line; it is truncated";
  static constexpr const char* kOverrun = "has a run that is longer than its scan line";

  std::size_t left() const { return bytes_.size() - at_; }

  /// The marker (2, 2, length), then each component's bytes for the whole line.
  template <bool kStore>
  const char* walkNew(std::size_t length, std::uint8_t* planes) {
    if (std::size_t(bytes_[at_ + 2]) * 256 + bytes_[at_ + 3] != length)
      return "has a scan line whose length is not the image's";
    at_ += 4;
    for (std::size_t plane = 0; plane < 4; ++plane)
      for (std::size_t filled = 0; filled < length;) {
        if (left() < 2) return kTruncated;
        const std::size_t code = bytes_[at_++];
        const bool repeats = code > kLongestLiteral;
        const std::size_t count = repeats ? code - kLongestLiteral : code;
        if (count == 0) return "has a run of no bytes";
        if (count > length - filled) return kOverrun;
        const std::size_t taken = repeats ? 1 : count;
        if (left() < taken) return kTruncated;
        if constexpr (kStore) {
          std::uint8_t* to = planes + plane * length + filled;
          if (repeats)
            std::memset(to, bytes_[at_], count);
          else
            std::memcpy(to, bytes_.data() + at_, count);
        }
        at_ += taken;
        filled += count;
      }
    return nullptr;
  }

  /// Whole texels; (1, 1, 1, n) repeats the one before n times, and the next such one behind it
  /// n · 256 times, and so on.
  template <bool kStore>
  const char* walkOld(std::size_t length, std::uint8_t* planes) {
    int shift = 0;
    for (std::size_t filled = 0; filled < length;) {
      if (left() < 4) return kTruncated;
      const std::uint8_t* texel = bytes_.data() + at_;
      if (texel[0] == 1 && texel[1] == 1 && texel[2] == 1) {
        if (filled == 0) return "has a scan line that begins with a repetition";
        if (shift > 24) return kOverrun;
        const std::size_t count = std::size_t(texel[3]) << shift;
        if (count > length - filled) return kOverrun;
        if constexpr (kStore)
          for (std::size_t plane = 0; plane < 4; ++plane) {
            std::uint8_t* to = planes + plane * length + filled;
            std::memset(to, to[-1], count);
          }
        filled += count;
        shift += 8;
        form_ = LineForm::old_rle;
      } else {
        if constexpr (kStore)
          for (std::size_t plane = 0; plane < 4; ++plane) planes[plane * length + filled] = texel[plane];
        ++filled;
        shift = 0;
      }
      at_ += 4;
    }
    return nullptr;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_;
  LineForm form_ = LineForm::flat;
};

/// Where each scan line begins, and what form the lines have.
struct LineIndex {
  std::vector<std::size_t> starts;
  LineForm form = LineForm::flat;
};

Result<LineIndex> indexLines(std::span<const std::uint8_t> bytes, const HdrHeader& header, const std::string& name) {
  const std::size_t left = bytes.size() - header.size;
  const std::size_t texels = header.lineCount() * header.lineLength();
  // A scan line has at least one whole texel.
  if (left / 4 < header.lineCount() || texels / kMostTexelsPerByte > left)
    return fail(ErrorCode::bad_file, name + ": says its size is " + std::to_string(header.width) + "x" +
                                         std::to_string(header.height) + ", but only " + std::to_string(left) +
                                         " bytes follow the header; the file is truncated");
  LineIndex index;
  index.starts.reserve(header.lineCount());
  LineWalker walker(bytes, header.size);
  for (std::size_t line = 0; line < header.lineCount(); ++line) {
    index.starts.push_back(walker.position());
    if (const char* wrong = walker.walk<false>(header.lineLength(), nullptr))
      return fail(ErrorCode::bad_file, name + ": " + wrong + " (scan line " + std::to_string(line) + ", byte " +
                                           std::to_string(walker.position()) + ")");
    index.form = std::max(index.form, walker.form());
  }
  return index;
}

/// 2^(exponent − 136): what one unit of a mantissa is worth. An exponent of 0 means black.
const std::array<float, 256>& unitTable() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> units{};
    for (int exponent = 1; exponent < 256; ++exponent) units[std::size_t(exponent)] = std::ldexp(1.0f, exponent - 136);
    return units;
  }();
  return table;
}

/// Where a scan line's first texel goes, and the step in samples to its next.
struct LinePlace {
  float* first;
  std::ptrdiff_t step;
};

LinePlace placeOf(std::size_t line, const HdrHeader& header, Image& image) {
  const int at = static_cast<int>(line);
  int x = header.x_descends ? header.width - 1 : 0;
  int y = header.y_ascends ? header.height - 1 : 0;
  if (header.columns) {
    x = header.x_descends ? x - at : at;
    const std::ptrdiff_t step = std::ptrdiff_t{3} * header.width;
    return {image.texel(x, y), header.y_ascends ? -step : step};
  }
  y = header.y_ascends ? y - at : at;
  return {image.texel(x, y), header.x_descends ? -3 : 3};
}

/// From planes of bytes to texels.
void storeLine(const std::uint8_t* planes, std::size_t length, glm::vec3 gain, LinePlace place) {
  const std::array<float, 256>& units = unitTable();
  const std::uint8_t* exponents = planes + 3 * length;
  float* texel = place.first;
  for (std::size_t i = 0; i < length; ++i) {
    const float unit = units[exponents[i]];
    texel[0] = static_cast<float>(planes[i]) * unit * gain.x;
    texel[1] = static_cast<float>(planes[length + i]) * unit * gain.y;
    texel[2] = static_cast<float>(planes[2 * length + i]) * unit * gain.z;
    if (i + 1 < length) texel += place.step;
  }
}

/// Brings the components to Rec.709 and says what they were.
std::string convertColor(const HdrHeader& header, Image& image) {
  if (header.xyz) {
    transformColors(image, glm::mat3(formula::rec709FromXyz({1, 0, 0}), formula::rec709FromXyz({0, 1, 0}),
                                     formula::rec709FromXyz({0, 0, 1})));
    return "CIE XYZ: converted";
  }
  convertToRec709(image, header.primaries);
  return describeColor(kLinearLight, header.primaries, image.channels());
}

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

/// How many bytes from `at` on are the same, up to the longest run.
std::size_t runLength(std::span<const std::uint8_t> plane, std::size_t at) {
  const std::size_t most = std::min(plane.size() - at, kLongestRun);
  std::size_t count = 1;
  while (count < most && plane[at + count] == plane[at]) ++count;
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

}  // namespace

bool isHdr(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kMagics[] = {"#?RADIANCE", "#?RGBE"};
  return std::any_of(std::begin(kMagics), std::end(kMagics), [&](std::string_view magic) {
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
  });
}

Result<DecodedImage> decodeHdr(std::span<const std::uint8_t> bytes, const std::string& name) {
  MIRRORBALL_TRY(header, parseHdrHeader(bytes, name));
  MIRRORBALL_TRY(index, indexLines(bytes, header, name));

  Image image = Image::withoutValues(header.width, header.height, 3);
  const std::size_t length = header.lineLength();
  const glm::vec3 gain = 1.0f / header.exposure;
  parallelFor(header.lineCount(), linesPerPiece(length), [&](std::size_t begin, std::size_t end) {
    Bytes planes(4 * length);
    for (std::size_t line = begin; line < end; ++line) {
      LineWalker walker(bytes, index.starts[line]);
      walker.walk<true>(length, planes.data());
      storeLine(planes.data(), length, gain, placeOf(line, header, image));
    }
  });
  std::string color = convertColor(header, image);

  constexpr const char* kForms[] = {"flat", "old RLE", "RLE"};
  return DecodedImage{
      std::move(image), std::move(header.metadata),
      std::string("Radiance HDR, ") + (header.xyz ? "XYZE, " : "") + kForms[static_cast<int>(index.form)],
      std::move(color)};
}

Bytes encodeHdr(const Image& image, const Metadata& metadata) {
  std::vector<Bytes> lines(std::size_t(image.height()));
  parallelFor(lines.size(), linesPerPiece(std::size_t(image.width())), [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) lines[y] = encodeLine(image, static_cast<int>(y));
  });

  std::string header = "#?RADIANCE\n";
  for (const auto& [key, value] : metadata) header += "# " + metadataLine(key, value) + "\n";
  header +=
      "FORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.height()) + " +X " + std::to_string(image.width()) + "\n";
  Bytes bytes(header.begin(), header.end());
  for (const Bytes& line : lines) bytes.insert(bytes.end(), line.begin(), line.end());
  return bytes;
}

}  // namespace mirrorball
