#include "mirrorball/codec/hdr/hdr_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "formula/color.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/missing_rows.h"

namespace mirrorball {
namespace {

/// The most texels that one byte of a real file stands for is some 3300: old RLE of a black line of
/// 65536 texels, which has 20 bytes. More is a lie that would only cost memory.
constexpr std::size_t kMaxTexelsPerByte = 4096;

/// Walks over scan lines. With `kStore`, their bytes go to four planes (all R, all G, all B, all
/// E); without, only the line's end is found: that pass is cheap, and proves that the second one,
/// which takes memory and runs in parallel, will not fail.
class LineWalker {
 public:
  LineWalker(std::span<const std::uint8_t> bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  static constexpr const char* kTruncated = "ends in the middle of a scan line; it is truncated";

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

LinePlace linePlace(std::size_t line, const HdrHeader& header, Image& image) {
  const int at = static_cast<int>(line);
  int x = header.x_descends ? image.width() - 1 : 0;
  int y = header.y_ascends ? image.height() - 1 : 0;
  if (header.columns) {
    x = header.x_descends ? x - at : at;
    const std::ptrdiff_t step = std::ptrdiff_t{3} * image.width();
    return {image.texel(x, y), header.y_ascends ? -step : step};
  }
  y = header.y_ascends ? y - at : at;
  return {image.texel(x, y), header.x_descends ? -3 : 3};
}

void blackenLine(std::size_t length, LinePlace place) {
  for (std::size_t i = 0; i < length; ++i) std::fill_n(place.first + std::ptrdiff_t(i) * place.step, 3, 0.0f);
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

}  // namespace

std::size_t linesPerPiece(std::size_t line_length) {
  constexpr std::size_t kTexelsPerPiece = 1 << 15;
  return 1 + kTexelsPerPiece / line_length;
}

std::string describe(const HdrHeader& header, LineForm form) {
  constexpr const char* kForms[] = {"flat", "old RLE", "RLE"};
  return std::string("Radiance HDR, ") + (header.xyz ? "XYZE, " : "") + kForms[static_cast<int>(form)];
}

std::string describeColor(const HdrHeader& header) {
  return header.xyz ? "CIE XYZ: converted" : describeColor(kLinearLight, header.primaries, 3);
}

Result<void> checkLineBytes(const HdrHeader& header, std::uint64_t left) {
  const std::size_t texels = header.lineCount() * header.lineLength();
  // A scan line has at least one whole texel.
  if (left / 4 >= header.lineCount() && texels / kMaxTexelsPerByte <= left) return {};
  return fail(ErrorCode::bad_file, "says its size is " + std::to_string(header.width) + "x" +
                                       std::to_string(header.height) + ", but only " + std::to_string(left) +
                                       " bytes follow the header; the file is truncated");
}

Result<LineIndex> indexLines(std::span<const std::uint8_t> bytes, std::size_t at, const HdrHeader& header,
                             std::size_t first, std::size_t count, std::uint64_t origin) {
  LineIndex index;
  index.starts.reserve(count);
  LineWalker walker(bytes, at);
  for (std::size_t line = first; line < first + count; ++line) {
    const std::size_t start = walker.position();
    index.end = start;
    const char* wrong = walker.walk<false>(header.lineLength(), nullptr);
    if (wrong == LineWalker::kTruncated) return index;
    if (wrong != nullptr)
      return fail(ErrorCode::bad_file, std::string(wrong) + " (scan line " + std::to_string(line) + ", byte " +
                                           std::to_string(origin + walker.position()) + ")");
    index.starts.push_back(start);
    index.form = std::max(index.form, walker.form());
    index.new_rle_count += walker.form() == LineForm::new_rle ? 1 : 0;
  }
  index.end = walker.position();
  return index;
}

Result<std::string> missingLinesRemark(const HdrHeader& header, std::size_t there, std::size_t new_rle_count,
                                       std::uint64_t size) {
  if (there == header.lineCount()) return std::string();
  if (there == 0) return endsInFirstRow(size);
  // Behind a damaged scan line the bytes of later ones pass for flat texels, up to where they end.
  if (new_rle_count > 0 && new_rle_count < there)
    return fail(ErrorCode::bad_file, std::string(LineWalker::kTruncated) + " or damaged before (scan line " +
                                         std::to_string(there) + " of " + std::to_string(header.lineCount()) + ")");
  return earlyEndText(header.lineCount() - there, header.columns ? "column" : "row");
}

void decodeLines(std::span<const std::uint8_t> bytes, const LineIndex& index, const HdrHeader& header, Image& image) {
  const std::size_t length = header.lineLength();
  const glm::vec3 gain = 1.0f / header.exposure;
  parallelFor(index.starts.size(), linesPerPiece(length), [&](std::size_t begin, std::size_t end) {
    Bytes planes(4 * length);
    for (std::size_t line = begin; line < end; ++line) {
      LineWalker walker(bytes, index.starts[line]);
      walker.walk<true>(length, planes.data());
      storeLine(planes.data(), length, gain, linePlace(line, header, image));
    }
  });
  const auto lines = static_cast<std::size_t>(header.columns ? image.width() : image.height());
  for (std::size_t line = index.starts.size(); line < lines; ++line)
    blackenLine(length, linePlace(line, header, image));
}

bool convertToRec709(Image& components, const HdrHeader& header) {
  if (!header.xyz) return convertToRec709(components, header.primaries);
  transformColors(components, glm::mat3(formula::rec709FromXyz({1, 0, 0}), formula::rec709FromXyz({0, 1, 0}),
                                        formula::rec709FromXyz({0, 0, 1})));
  return true;
}

}  // namespace mirrorball
