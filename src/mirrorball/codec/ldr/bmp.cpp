#include "mirrorball/codec/ldr/bmp.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <utility>
#include <vector>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/color/icc_profile.h"
#include "mirrorball/codec/missing_rows.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;
using BmpColor = std::array<std::uint8_t, 4>;

constexpr std::size_t kFileHeader = 14;
constexpr std::size_t kCoreHeader = 12;  // OS/2's first
constexpr std::size_t kInfoHeader = 40;  // Windows 3's, on which all later ones build
constexpr std::size_t kFifthHeader = 124;

enum BmpCompression : std::uint32_t { kPlain = 0, kRle8 = 1, kRle4 = 2, kMasks = 3, kMasksWithAlpha = 6 };

struct BmpHeader {
  std::size_t size = 0;  ///< of the header behind the file's
  std::size_t texels_at = 0;
  std::int64_t width = 0;
  std::int64_t height = 0;
  bool from_top = false;
  std::uint32_t bits = 0;
  std::uint32_t compression = kPlain;
  std::uint32_t colors = 0;
  std::array<std::uint32_t, 4> masks{};  ///< red, green, blue, alpha

  bool hasPalette() const { return bits <= 8; }
  bool isRunLengthCoded() const { return compression == kRle8 || compression == kRle4; }
  std::size_t rowBytes() const { return (std::size_t(width) * bits + 31) / 32 * 4; }
  std::size_t texelCount() const { return std::size_t(width) * std::size_t(height); }
};

tl::unexpected<Error> truncated(std::size_t size) {
  return fail(ErrorCode::bad_file,
              "ends at byte " + std::to_string(size) + ", before its first texel; the file is truncated or damaged");
}

/// Whether texels of that many bits can be compressed so.
bool isKnown(const BmpHeader& header) {
  constexpr std::array<std::uint32_t, 7> kBits{1, 2, 4, 8, 16, 24, 32};
  if (!contains(kBits, header.bits)) return false;
  switch (header.compression) {
    case kPlain:
      return true;
    case kRle8:
      return header.bits == 8;
    case kRle4:
      return header.bits == 4;
    case kMasks:
    case kMasksWithAlpha:
      return header.bits == 16 || header.bits == 32;
    default:
      return false;
  }
}

/// Where masks are named they lie behind the 40 bytes of the third header, or as a part of later ones.
Result<void> readMasks(Span bytes, BmpHeader& header) {
  if (header.compression == kPlain) {
    if (header.bits == 16) header.masks = {0x7c00, 0x3e0, 0x1f, 0};
    if (header.bits == 32) header.masks = {0xff0000, 0xff00, 0xff, 0};
    return {};
  }
  const bool has_alpha = header.compression == kMasksWithAlpha || header.size >= kInfoHeader + 16;
  const std::size_t count = has_alpha ? 4 : 3;
  if (bytes.size() < kFileHeader + kInfoHeader + 4 * count) return truncated(bytes.size());
  for (std::size_t i = 0; i < count; ++i) header.masks[i] = littleU32(&bytes[kFileHeader + kInfoHeader + 4 * i]);
  return {};
}

Result<BmpHeader> readBmpHeader(Span bytes) {
  if (bytes.size() < kFileHeader + kCoreHeader) return truncated(bytes.size());
  BmpHeader header{.size = littleU32(&bytes[kFileHeader]), .texels_at = littleU32(&bytes[10])};
  const bool is_core = header.size == kCoreHeader;
  if (!is_core && (header.size < 16 || header.size > 1000))
    return fail(ErrorCode::bad_file, "says that its header has " + counted(header.size, "byte") +
                                         ", which no bitmap's has; the file is damaged");
  if (bytes.size() < kFileHeader + header.size) return truncated(bytes.size());
  const std::uint8_t* fields = &bytes[kFileHeader];
  if (is_core) {
    header.width = littleU16(fields + 4);
    header.height = littleU16(fields + 6);
    header.bits = littleU16(fields + 10);
  } else {
    header.width = static_cast<std::int32_t>(littleU32(fields + 4));
    header.height = static_cast<std::int32_t>(littleU32(fields + 8));
    header.bits = littleU16(fields + 14);
    if (header.size >= 20) header.compression = littleU32(fields + 16);
    if (header.size >= 36) header.colors = littleU32(fields + 32);
  }
  header.from_top = header.height < 0;
  header.height = std::abs(header.height);
  MIRRORBALL_TRY_VOID(checkDimensions(header.width, header.height));
  if (!isKnown(header))
    return fail(ErrorCode::unsupported, "is a bitmap of " + counted(header.bits, "bit") + " with compression " +
                                            std::to_string(header.compression) +
                                            ", which is not read; save it plain, or as PNG");
  if (!header.isRunLengthCoded() && !header.hasPalette() && header.bits != 24)
    MIRRORBALL_TRY_VOID(readMasks(bytes, header));
  return header;
}

/// Whether its bytes can be the texels, or some of them.
Result<void> checkTexels(const BmpHeader& header, Span bytes) {
  const int width = static_cast<int>(header.width);
  const int height = static_cast<int>(header.height);
  MIRRORBALL_TRY_VOID(checkPictureMemory(width, height, 4, 2));  // palette indices, and codes
  const std::size_t there = bytes.size() - std::min(header.texels_at, bytes.size());
  // Two bytes make at most 255 texels, and a run-length coded file may skip some, but hardly most of a large picture.
  constexpr std::size_t kSmall = 65536;
  const bool fits = header.isRunLengthCoded()
                        ? there >= 2 && (header.texelCount() <= kSmall || mayBeLeftOf(header.texelCount() / 128, there))
                        : there > 0 && mayBeLeftOf(std::uint64_t{header.rowBytes()} * std::size_t(height), there);
  if (!fits) return cannotHold(width, height, bytes.size());
  return {};
}

/// Blue, green and red, and a byte that means nothing but in OS/2's first version, which lacks it.
Result<std::vector<BmpColor>> readPalette(const BmpHeader& header, Span bytes) {
  if (!header.hasPalette()) return std::vector<BmpColor>();
  const std::size_t max = std::size_t{1} << header.bits;
  const std::size_t entry = header.size == kCoreHeader ? 3 : 4;
  const std::size_t at = kFileHeader + header.size;
  const std::size_t end = std::min(header.texels_at, bytes.size());
  const std::size_t there = end < at ? 0 : (end - at) / entry;
  const std::size_t count = header.colors == 0 ? max : std::min<std::size_t>(header.colors, max);
  if (there < count && header.colors != 0)
    return fail(ErrorCode::bad_file, "says that its palette has " + counted(count, "colour") + ", and has room for " +
                                         std::to_string(there) + "; the file is damaged");
  std::vector<BmpColor> palette;
  for (std::size_t i = 0; i < std::min(count, there); ++i) {
    const std::uint8_t* color = &bytes[at + i * entry];
    palette.push_back({color[2], color[1], color[0], 255});
  }
  return palette;
}

/// Palette indices out of RLE4 or RLE8; what a file skips has the index 0.
class RunReader {
 public:
  RunReader(const BmpHeader& header, Span bytes) : header_(header), bytes_(bytes), indices_(header.texelCount(), 0) {}

  /// Rows as they are stored.
  std::vector<std::uint8_t> read() {
    while (const auto code = next(2)) {
      const std::uint8_t count = code[0];
      const std::uint8_t value = code[1];
      if (count > 0) {
        run(count, value);
      } else if (value == 0) {
        x_ = 0;
        ++y_;
        if (y_ > header_.height) break;  // more rows than there are
      } else if (value == 1) {
        y_ = header_.height;
        break;
      } else if (value == 2) {
        const std::uint8_t* skip = next(2);
        if (!skip) break;
        x_ += skip[0];
        y_ += skip[1];
      } else if (!literal(value)) {
        break;
      }
    }
    return std::move(indices_);
  }

  /// How many of them are whole. Some writers leave out the code for the end of the last.
  int rows() const {
    const std::int64_t ended = y_ + (y_ == header_.height - 1 && x_ >= header_.width ? 1 : 0);
    return static_cast<int>(std::min(ended, header_.height));
  }

 private:
  const std::uint8_t* next(std::size_t count) {
    if (bytes_.size() - at_ < count) return nullptr;
    at_ += count;
    return &bytes_[at_ - count];
  }

  /// What lies beyond a row's end is left out.
  void put(std::uint8_t index) {
    if (x_ < header_.width && y_ < header_.height)
      indices_[std::size_t(y_) * std::size_t(header_.width) + std::size_t(x_)] = index;
    ++x_;
  }

  /// The i-th index of those in a byte, or in bytes from there on.
  std::uint8_t indexIn(const std::uint8_t* value, std::size_t i) const {
    if (header_.compression == kRle8) return value[i];
    return i % 2 == 0 ? value[i / 2] >> 4 : value[i / 2] & 15;
  }

  void run(std::uint8_t count, std::uint8_t value) {
    for (std::size_t i = 0; i < count; ++i) put(indexIn(&value, header_.compression == kRle8 ? 0 : i % 2));
  }

  /// Literal runs are padded to 16 bits.
  bool literal(std::uint8_t count) {
    const std::size_t size = header_.compression == kRle8 ? count : (count + 1u) / 2;
    const std::uint8_t* values = next(size);
    if (!values) return false;
    for (std::size_t i = 0; i < count; ++i) put(indexIn(values, i));
    at_ = std::min(at_ + size % 2, bytes_.size());
    return true;
  }

  const BmpHeader& header_;
  Span bytes_;
  std::size_t at_ = 0;
  std::int64_t x_ = 0;
  std::int64_t y_ = 0;
  std::vector<std::uint8_t> indices_;
};

/// The code under a mask, widened to 8 bits; alpha without a mask is 255.
std::uint8_t underMask(std::uint32_t texel, std::uint32_t mask, std::uint8_t without) {
  if (mask == 0) return without;
  const int shift = std::countr_zero(mask);
  return static_cast<std::uint8_t>(rescaledCode((texel & mask) >> shift, mask >> shift, 255));
}

/// A texel of a row that has no palette.
BmpColor colorAt(const BmpHeader& header, const std::uint8_t* row, std::size_t x) {
  if (header.bits == 24) return {row[3 * x + 2], row[3 * x + 1], row[3 * x], 255};
  const std::uint32_t texel = header.bits == 16 ? littleU16(row + 2 * x) : littleU32(row + 4 * x);
  return {underMask(texel, header.masks[0], 0), underMask(texel, header.masks[1], 0),
          underMask(texel, header.masks[2], 0), underMask(texel, header.masks[3], 255)};
}

/// The palette's index of a texel in a plain row: the first is in the byte's highest bits.
std::uint8_t indexAt(std::uint32_t bits, const std::uint8_t* row, std::size_t x) {
  const std::size_t bit = x * bits;
  return static_cast<std::uint8_t>(row[bit / 8] >> (8 - bits - bit % 8) & ((1u << bits) - 1));
}

/// The rows of texels, or of a palette's indices, that a file holds.
class Rows {
 public:
  Rows(const BmpHeader& header, Span texels, int count) : header_(header), texels_(texels), count_(count) {}

  int count() const { return count_; }

  /// A row, in the order of the file.
  const std::uint8_t* operator[](int row) const {
    const std::size_t size = header_.isRunLengthCoded() ? std::size_t(header_.width) : header_.rowBytes();
    return texels_.data() + std::size_t(row) * size;
  }

  /// Where it is shown, from the top.
  int shown(int row) const { return header_.from_top ? row : static_cast<int>(header_.height) - 1 - row; }

 private:
  const BmpHeader& header_;
  Span texels_;
  int count_;
};

void fillFromMasks(const BmpHeader& header, const Rows& rows, Image8& picture) {
  for (int row = 0; row < rows.count(); ++row)
    for (int x = 0; x < picture.width(); ++x) {
      const BmpColor color = colorAt(header, rows[row], std::size_t(x));
      std::copy_n(color.begin(), picture.channels(), picture.texel(x, rows.shown(row)));
    }
}

Result<void> fillFromPalette(const BmpHeader& header, const Rows& rows, const std::vector<BmpColor>& palette,
                             Image8& picture) {
  const std::uint32_t bits = header.isRunLengthCoded() ? 8 : header.bits;  // of an index
  for (int row = 0; row < rows.count(); ++row)
    for (int x = 0; x < picture.width(); ++x) {
      const std::size_t index = indexAt(bits, rows[row], std::size_t(x));
      if (index >= palette.size())
        return fail(ErrorCode::bad_file, "texel (" + std::to_string(x) + ", " + std::to_string(rows.shown(row)) +
                                             ") has the colour " + std::to_string(index) + " of a palette of " +
                                             std::to_string(palette.size()) + "; the file is damaged");
      std::copy_n(palette[index].begin(), picture.channels(), picture.texel(x, rows.shown(row)));
    }
  return {};
}

/// oddities   receives the remark on rows that are missing
Result<Image8> readBmpPicture(const BmpHeader& header, Span bytes, std::vector<std::string>& oddities) {
  MIRRORBALL_TRY_VOID(checkTexels(header, bytes));
  MIRRORBALL_TRY(palette, readPalette(header, bytes));
  Span texels = bytes.subspan(header.texels_at);
  auto count = static_cast<int>(std::min(texels.size() / header.rowBytes(), std::size_t(header.height)));
  std::vector<std::uint8_t> indices;
  if (header.isRunLengthCoded()) {
    RunReader reader(header, texels);
    indices = reader.read();
    texels = indices;
    count = reader.rows();
  }
  if (count == 0) return endsInFirstRow(bytes.size());
  Image8 picture = Image8::withoutValues(static_cast<int>(header.width), static_cast<int>(header.height),
                                         header.masks[3] != 0 ? 4 : 3);
  const Rows rows(header, texels, count);
  if (header.hasPalette()) {
    MIRRORBALL_TRY_VOID(fillFromPalette(header, rows, palette, picture));
  } else {
    fillFromMasks(header, rows, picture);
  }
  blackenMissingRows(picture, count, header.from_top, oddities);
  return picture;
}

/// The embedded ICC profile, if there is one.
IccProfile bmpProfile(const BmpHeader& header, Span bytes) {
  constexpr std::uint32_t kEmbedded = 0x4d424544;  // "MBED"
  if (header.size < kFifthHeader || littleU32(&bytes[kFileHeader + 56]) != kEmbedded) return {};
  const std::size_t at = kFileHeader + std::size_t{littleU32(&bytes[kFileHeader + 112])};
  const std::size_t size = littleU32(&bytes[kFileHeader + 116]);
  if (at > bytes.size() || size > bytes.size() - at) return readIccProfile({});
  return readIccProfile(bytes.subspan(at, size));
}

}  // namespace

bool isBmp(Span bytes) {
  // Two letters are few; the upper bytes of the header's size are 0 in every bitmap.
  return bytes.size() >= kFileHeader + 4 && bytes[0] == 'B' && bytes[1] == 'M' && bytes[16] == 0 && bytes[17] == 0;
}

Result<CodedFile> decodeBmp(Span bytes, CodeForm) {
  MIRRORBALL_TRY(header, readBmpHeader(bytes));
  std::vector<std::string> oddities;
  MIRRORBALL_TRY(picture, readBmpPicture(header, bytes, oddities));
  std::string format = "BMP, " + std::to_string(header.bits) + " bit";
  if (header.hasPalette()) format += " palette";
  if (header.isRunLengthCoded()) format += ", RLE";
  return CodedFile{.codes = std::move(picture),
                   .color = codedColor(bmpProfile(header, bytes)),
                   .format = std::move(format),
                   .oddities = std::move(oddities)};
}

}  // namespace mirrorball
