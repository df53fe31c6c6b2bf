#include "mirrorball/codec/ldr/tga.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "mirrorball/base/range.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/missing_rows.h"
#include "mirrorball/codec/within_memory.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;
using TgaColor = std::array<std::uint8_t, 4>;

constexpr std::size_t kHeaderSize = 18;
constexpr std::string_view kSignature("TRUEVISION-XFILE.", 18);  // with its closing 0
constexpr std::size_t kFooterSize = 8 + kSignature.size();

/// A packet says at most 128 texels in one texel's bytes and its own.
constexpr std::size_t kMaxTexelsPerPacket = 128;

enum class Kind { palette = 1, colors = 2, grey = 3 };

struct TgaHeader {
  std::size_t id_length;
  bool has_palette;
  Kind kind;
  bool is_run_length_coded;
  std::uint32_t palette_first, palette_length, palette_bits;
  int width, height;
  std::uint32_t bits;  ///< of a texel
  std::uint32_t alpha_bits;
  bool from_right, from_top;

  std::size_t paletteBytes() const { return has_palette ? palette_length * ((palette_bits + 7) / 8) : 0; }
  std::size_t texelsAt() const { return kHeaderSize + id_length + paletteBytes(); }
  std::size_t texelBytes() const { return (bits + 7) / 8; }
  std::size_t texelCount() const { return std::size_t(width) * std::size_t(height); }
  std::size_t rowBytes() const { return std::size_t(width) * texelBytes(); }
};

bool isColorDepth(std::uint32_t bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

/// The header, if each of its numbers is one that the format has.
std::optional<TgaHeader> readTgaHeader(Span bytes) {
  if (bytes.size() < kHeaderSize) return {};
  const std::uint32_t type = bytes[2];
  const std::uint32_t descriptor = bytes[17];
  const TgaHeader header{.id_length = bytes[0],
                         .has_palette = bytes[1] == 1,
                         .kind = static_cast<Kind>(type & 7),
                         .is_run_length_coded = type >= 9,
                         .palette_first = littleU16(&bytes[3]),
                         .palette_length = littleU16(&bytes[5]),
                         .palette_bits = bytes[7],
                         .width = littleU16(&bytes[12]),
                         .height = littleU16(&bytes[14]),
                         .bits = bytes[16],
                         .alpha_bits = descriptor & 15,
                         .from_right = (descriptor & 16) != 0,
                         .from_top = (descriptor & 32) != 0};
  constexpr std::array<std::uint32_t, 6> kTypes{1, 2, 3, 9, 10, 11};
  if (!contains(kTypes, type) || bytes[1] > 1 || (descriptor & 0xc0) != 0) return {};
  if (header.has_palette && !isColorDepth(header.palette_bits)) return {};
  if (header.kind == Kind::colors) return isColorDepth(header.bits) ? std::optional(header) : std::nullopt;
  if (header.bits != 8 && header.bits != 16) return {};
  if (header.kind == Kind::palette && !header.has_palette) return {};
  return header;
}

/// What the last bytes of a file of version 2 say of alpha.
enum class AlphaType { unsaid, none, straight, premultiplied };

bool hasFooter(Span bytes) {
  return bytes.size() >= kFooterSize &&
         std::equal(kSignature.begin(), kSignature.end(), bytes.end() - std::ptrdiff_t(kSignature.size()));
}

AlphaType readAlphaType(Span bytes) {
  constexpr std::size_t kTypeAt = 494;
  if (!hasFooter(bytes)) return AlphaType::unsaid;
  const std::size_t area = littleU32(&bytes[bytes.size() - kFooterSize]);
  if (area == 0 || area > bytes.size() || bytes.size() - area <= kTypeAt) return AlphaType::unsaid;
  switch (bytes[area + kTypeAt]) {
    case 3:
      return AlphaType::straight;
    case 4:
      return AlphaType::premultiplied;
    default:
      return AlphaType::none;
  }
}

/// 15 and 16 bits are ARRRRRGGGGGBBBBB, 24 and 32 are blue, green, red and alpha.
TgaColor unpackColor(const std::uint8_t* stored, std::uint32_t bits) {
  if (bits >= 24) return {stored[2], stored[1], stored[0], bits == 32 ? stored[3] : std::uint8_t{255}};
  const std::uint32_t all = littleU16(stored);
  const auto widened = [](std::uint32_t code) { return static_cast<std::uint8_t>(rescaledCode(code & 31, 31, 255)); };
  return {widened(all >> 10), widened(all >> 5), widened(all), static_cast<std::uint8_t>((all >> 15) * 255)};
}

/// Copies texels, or repeats one, as the packets say. They may run from one row into the next.
///
/// returns  how many bytes of texels there are, where the packets end before the texels do
std::size_t unpackRuns(Span packed, std::size_t texel_bytes, std::span<std::uint8_t> texels) {
  const std::size_t all = texels.size();
  while (!texels.empty() && !packed.empty()) {
    const bool is_run = packed[0] >= 128;
    const std::size_t size = std::min(((packed[0] & 127u) + 1) * texel_bytes, texels.size());
    packed = packed.subspan(1);
    const std::size_t stored = is_run ? texel_bytes : size;
    if (packed.size() < stored) break;
    for (std::size_t at = 0; at < size; at += stored) std::copy_n(packed.begin(), stored, texels.begin() + at);
    packed = packed.subspan(stored);
    texels = texels.subspan(size);
  }
  return all - texels.size();
}

class TgaReader {
 public:
  TgaReader(Span bytes, const TgaHeader& header) : bytes_(bytes), header_(header) {}

  /// oddities   receives the remark on rows that are missing
  Result<CodedPicture> read(std::vector<std::string>& oddities) {
    MIRRORBALL_TRY_VOID(check());
    MIRRORBALL_TRY_VOID(unpack());
    readPalette();
    MIRRORBALL_TRY_VOID(checkIndices());
    const AlphaType alpha = readAlphaType(bytes_);
    const bool has_alpha = alpha == AlphaType::unsaid ? saysAlpha() : alpha != AlphaType::none && hasPlaceForAlpha();
    const int channels = has_alpha ? 4 : header_.kind == Kind::grey ? 1 : 3;
    Image8 picture = Image8::withoutValues(header_.width, header_.height, channels);
    std::uint8_t max_alpha = 0;
    for (int row = 0; row < rows_; ++row)
      for (int x = 0; x < header_.width; ++x) {
        const TgaColor color = colorAt(texelAt(x, row));
        std::copy_n(color.begin(), channels, picture.texel(x, shownRow(row)));
        max_alpha = std::max(max_alpha, color[3]);
      }
    blackenMissingRows(picture, rows_, header_.from_top, oddities);
    // Some programs say that there is alpha and leave it at 0, which would make the whole picture invisible.
    if (has_alpha && max_alpha == 0)
      for (std::size_t i = 3; i < picture.samples().size(); i += 4) picture.samples()[i] = 255;
    CodedPicture coded = std::move(picture);
    if (alpha == AlphaType::premultiplied) makeStraight(coded);
    return coded;
  }

 private:
  std::uint32_t colorBits() const { return header_.kind == Kind::palette ? header_.palette_bits : header_.bits; }
  bool hasPlaceForAlpha() const { return colorBits() == 32 || colorBits() == 16; }
  /// Grey of 16 bits has nothing else in its second byte, whether the header says so or not.
  bool saysAlpha() const { return hasPlaceForAlpha() && (header_.kind == Kind::grey || header_.alpha_bits > 0); }

  Result<void> check() const {
    MIRRORBALL_TRY_VOID(checkDimensions(header_.width, header_.height));
    constexpr int kSampleBytes = 2;  // as packets leave them, and as codes
    MIRRORBALL_TRY_VOID(checkPictureMemory(header_.width, header_.height, 4, kSampleBytes));
    const std::size_t size = bytes_.size();
    const std::size_t there = size - std::min(header_.texelsAt(), size);
    const std::size_t min = header_.is_run_length_coded
                                ? header_.texelCount() / kMaxTexelsPerPacket * (header_.texelBytes() + 1)
                                : header_.texelCount() * header_.texelBytes();
    if (!mayBeLeftOf(min, there) || there == 0) return cannotHold(header_.width, header_.height, size);
    return {};
  }

  Result<void> unpack() {
    const Span stored = bytes_.subspan(header_.texelsAt());
    const std::size_t size = header_.texelCount() * header_.texelBytes();
    texels_ = stored;
    if (header_.is_run_length_coded) {
      // Without values, so that a size that lies costs no memory: only texels that are there are touched.
      unpacked_ = bytesWithoutValues(size);
      texels_ = {unpacked_.get(), unpackRuns(stored, header_.texelBytes(), {unpacked_.get(), size})};
    }
    rows_ = static_cast<int>(std::min(texels_.size(), size) / header_.rowBytes());
    return rows_ > 0 ? Result<void>() : endsInFirstRow(bytes_.size());
  }

  void readPalette() {
    if (!header_.has_palette) return;
    const std::size_t entry = (header_.palette_bits + 7) / 8;
    const std::uint8_t* stored = bytes_.data() + kHeaderSize + header_.id_length;
    for (std::size_t i = 0; i < header_.palette_length; ++i)
      palette_.push_back(unpackColor(stored + i * entry, header_.palette_bits));
  }

  /// Where a row of the file is shown, from the top.
  int shownRow(int row) const { return header_.from_top ? row : header_.height - 1 - row; }

  /// The texel that is shown there in a row of the file.
  const std::uint8_t* texelAt(int x, int row) const {
    const int column = header_.from_right ? header_.width - 1 - x : x;
    return texels_.data() +
           (std::size_t(row) * std::size_t(header_.width) + std::size_t(column)) * header_.texelBytes();
  }

  /// The palette's entry for a texel.
  std::size_t paletteIndex(const std::uint8_t* texel) const {
    return std::size_t(header_.bits == 16 ? littleU16(texel) : texel[0]) - header_.palette_first;
  }

  Result<void> checkIndices() const {
    if (header_.kind != Kind::palette) return {};
    for (int row = 0; row < rows_; ++row)
      for (int x = 0; x < header_.width; ++x)
        if (paletteIndex(texelAt(x, row)) >= palette_.size())
          return fail(ErrorCode::bad_file, "texel (" + std::to_string(x) + ", " + std::to_string(shownRow(row)) +
                                               ") has a colour that the palette of " + std::to_string(palette_.size()) +
                                               " does not; the file is damaged");
    return {};
  }

  TgaColor colorAt(const std::uint8_t* texel) const {
    if (header_.kind == Kind::colors) return unpackColor(texel, header_.bits);
    if (header_.kind == Kind::palette) return palette_[paletteIndex(texel)];
    return {texel[0], texel[0], texel[0], header_.bits == 16 ? texel[1] : std::uint8_t{255}};
  }

  Span bytes_;
  const TgaHeader& header_;
  std::unique_ptr<std::uint8_t[]> unpacked_;
  Span texels_;
  int rows_ = 0;  ///< that the file holds whole
  std::vector<TgaColor> palette_;
};

}  // namespace

bool isTga(Span bytes) { return hasFooter(bytes) || readTgaHeader(bytes); }

Result<CodedFile> decodeTga(Span bytes, CodeForm) {
  const auto header = readTgaHeader(bytes);
  if (!header) return fail(ErrorCode::bad_file, "is a TGA whose first 18 bytes are not those of one");
  std::vector<std::string> oddities;
  MIRRORBALL_TRY(codes, TgaReader(bytes, *header).read(oddities));
  std::string format = "TGA, " + std::to_string(header->bits) + " bit";
  if (header->kind == Kind::palette) format += " palette";
  if (header->is_run_length_coded) format += ", RLE";
  return CodedFile{.codes = std::move(codes), .format = std::move(format), .oddities = std::move(oddities)};
}

}  // namespace mirrorball
