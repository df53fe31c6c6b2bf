#include "mirrorball/codec/texture/stored_format.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/bc6h/bc6h.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/color/shared_exponent.h"
#include "mirrorball/codec/half_blocks/half_rows.h"
#include "mirrorball/codec/texture/format_numbers.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr.h"
#include "mirrorball/image/small_float.h"

namespace mirrorball {
namespace {

static_assert(std::endian::native == std::endian::little, "texels are copied as they lie in memory");

/// Rows are decoded in pieces of about so many texels.
constexpr std::size_t kTexelsPerPiece = std::size_t{1} << 14;

/// Light of every 8-bit code, sRGB-encoded or not.
const std::array<float, 256>& lightOfCodes(bool srgb) {
  static const auto tables = [] {
    std::array<std::array<float, 256>, 2> made{};
    for (std::size_t code = 0; code < 256; ++code) {
      made[0][code] = static_cast<float>(code) / 255.0f;
      made[1][code] = formula::linearFromSrgb1(made[0][code]);
    }
    return made;
  }();
  return tables[srgb ? 1 : 0];
}

/// One row of samples that are numbers of their own, in the file's order of channels.
void unpackSamples(const StoredFormat& format, const std::uint8_t* bytes, std::size_t count, float* samples) {
  switch (format.type) {
    case SampleType::srgb8:
    case SampleType::unorm8: {
      const std::array<float, 256>& light = lightOfCodes(format.type == SampleType::srgb8);
      for (std::size_t i = 0; i < count; ++i) samples[i] = light[bytes[i]];
      // Alpha is never encoded.
      if (format.channels == 4)
        for (std::size_t i = 3; i < count; i += 4) samples[i] = static_cast<float>(bytes[i]) / 255.0f;
      return;
    }
    case SampleType::unorm16:
      for (std::size_t i = 0; i < count; ++i)
        samples[i] = static_cast<float>(bytes[2 * i] | bytes[2 * i + 1] << 8) / 65535.0f;
      return;
    case SampleType::half: {
      std::array<std::uint16_t, 1024> halves;  // an aligned copy, small enough for the nearest cache
      for (std::size_t begin = 0; begin < count; begin += halves.size()) {
        const std::size_t part = std::min(halves.size(), count - begin);
        std::memcpy(halves.data(), bytes + 2 * begin, 2 * part);
        floatsFromHalves(std::span(halves).first(part), std::span(samples + begin, part));
      }
      return;
    }
    default:
      assert(format.type == SampleType::float32);
      std::memcpy(samples, bytes, 4 * count);
  }
}

void unpackPacked(SampleType type, const std::uint8_t* bytes, std::size_t texels, float* samples) {
  for (std::size_t i = 0; i < texels; ++i) {
    const std::uint32_t bits = littleU32(bytes + 4 * i);
    glm::vec3 color;
    if (type == SampleType::e5b9g9r9) {
      color = colorFromSharedExponent(bits);
    } else {
      // Red has 11 bits and blue 10, which lack the half's last 4 and 5.
      color.x = floatFromHalf(static_cast<std::uint16_t>((bits & 0x7ffu) << 4));
      color.y = floatFromHalf(static_cast<std::uint16_t>((bits >> 11 & 0x7ffu) << 4));
      color.z = floatFromHalf(static_cast<std::uint16_t>((bits >> 22) << 5));
    }
    samples[3 * i] = color.x;
    samples[3 * i + 1] = color.y;
    samples[3 * i + 2] = color.z;
  }
}

bool isPacked(SampleType type) { return type == SampleType::b10g11r11 || type == SampleType::e5b9g9r9; }
bool isBc6h(SampleType type) { return type == SampleType::bc6h_unsigned || type == SampleType::bc6h_signed; }
bool isCompressed(SampleType type) { return isBc6h(type) || type == SampleType::uastc_hdr; }
bool isInBits(SampleType type) { return type == SampleType::srgb_bits || type == SampleType::unorm_bits; }

/// "a1r5g5b5", from the highest bits to the lowest; "a4l4" where red, green and blue are one.
std::string nameOfBits(const StoredFormat& format) {
  const bool is_luminance = format.masks[0] == format.masks[1];
  std::array<std::pair<std::uint32_t, char>, 4> channels{};
  for (std::size_t c = 0; c < 4; ++c)
    channels[c] = {is_luminance && (c == 1 || c == 2) ? 0 : format.masks[c], is_luminance && c == 0 ? 'l' : "rgba"[c]};
  std::sort(channels.begin(), channels.end(), std::greater<>());
  std::string name;
  for (const auto& [mask, letter] : channels)
    if (mask != 0) name += letter + std::to_string(std::popcount(mask));
  return name;
}

/// Texels of bits in words. The light of each code is looked up: there are few.
Image unpackBits(const StoredFormat& format, const std::uint8_t* bytes, std::size_t row_pitch, Image image) {
  std::array<std::vector<float>, 4> light;
  std::array<int, 4> shifts{};
  const auto channels = static_cast<std::size_t>(image.channels());
  for (std::size_t c = 0; c < channels; ++c) {
    shifts[c] = format.masks[c] == 0 ? 0 : std::countr_zero(format.masks[c]);
    const std::uint32_t max = format.masks[c] >> shifts[c];
    for (std::uint32_t code = 0; code <= max; ++code) {
      const float share = static_cast<float>(code) / static_cast<float>(std::max(max, 1u));
      light[c].push_back(hasSrgbCurve(format) && c < 3 ? formula::linearFromSrgb1(share) : share);
    }
  }
  const std::size_t rows_per_piece = std::max<std::size_t>(kTexelsPerPiece / std::size_t(image.width()), 1);
  parallelFor(std::size_t(image.height()), rows_per_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) {
      const std::uint8_t* word = bytes + y * row_pitch;
      float* texel = image.row(static_cast<int>(y)).data();
      for (int x = 0; x < image.width(); ++x, word += format.word_bytes, texel += channels) {
        std::uint32_t bits = 0;
        for (std::uint32_t i = 0; i < format.word_bytes; ++i) bits |= std::uint32_t{word[i]} << 8 * i;
        for (std::size_t c = 0; c < channels; ++c) texel[c] = light[c][(bits & format.masks[c]) >> shifts[c]];
      }
    }
  });
  return image;
}

/// One row, to the channels and the order of an image.
void unpackRow(const StoredFormat& format, const std::uint8_t* bytes, std::span<float> row,
               std::vector<float>& scratch) {
  const std::size_t to = std::size_t(imageChannels(format));
  const std::size_t texels = row.size() / to;
  if (isPacked(format.type)) return unpackPacked(format.type, bytes, texels, row.data());

  const std::size_t from = std::size_t(format.channels);
  const bool in_place = from == to && !format.blue_first;
  if (!in_place) scratch.resize(texels * from);
  float* samples = in_place ? row.data() : scratch.data();
  unpackSamples(format, bytes, texels * from, samples);
  if (in_place) return;
  for (std::size_t i = 0; i < texels; ++i) {
    for (std::size_t c = 0; c < to; ++c) row[i * to + c] = c < from ? samples[i * from + c] : 0.0f;
    if (format.blue_first) std::swap(row[i * to], row[i * to + 2]);
  }
}

/// Rows of blocks of UASTC HDR.
Result<Image> unpackUastcHdr(const std::uint8_t* bytes, std::size_t row_pitch, Image image) {
  const auto rows = static_cast<std::size_t>((image.height() + 3) / 4);
  std::vector<int> unread(rows, -1);  // the first block of each row that cannot be read
  parallelFor(rows, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      unread[row] = decodeUastcHdrRow(bytes + row * row_pitch, static_cast<int>(4 * row), image);
  });
  for (std::size_t row = 0; row < rows; ++row)
    if (unread[row] >= 0)
      return unsupportedTexture("ASTC that UASTC HDR 4x4 does not have, first in block (" +
                                    std::to_string(unread[row]) + ", " + std::to_string(row) + ")",
                                "r16g16b16a16 sfloat");
  return image;
}

/// The largest value of each channel; what is negative does not fit any of the packed formats.
glm::vec3 largestOf(TexelFormat format) {
  if (format == TexelFormat::e5b9g9r9) return glm::vec3(kLargestSharedExponent);
  return {kLargestSmallFloat<6>, kLargestSmallFloat<6>, kLargestSmallFloat<5>};
}

bool packPacked(TexelFormat format, std::span<const float> samples, std::size_t channels, std::uint8_t* bytes) {
  const glm::vec3 largest = largestOf(format);
  const bool holds_non_finite = format == TexelFormat::b10g11r11;
  const std::size_t green = channels == 1 ? 0 : 1;
  const std::size_t blue = channels == 1 ? 0 : 2;
  bool all_fit = true;
  for (std::size_t i = 0; i * channels < samples.size(); ++i) {
    const float* texel = samples.data() + i * channels;
    const glm::vec3 color(texel[0], texel[green], texel[blue]);
    bool fits = true;
    for (int c = 0; c < 3; ++c) {
      const bool is_special = !(color[c] < std::numeric_limits<float>::infinity());  // NaN too
      fits &= (color[c] >= 0.0f && color[c] <= largest[c]) || (holds_non_finite && is_special);
    }
    all_fit &= fits;
    std::uint32_t bits = 0;
    if (fits && format == TexelFormat::e5b9g9r9)
      bits = sharedExponentFromColor(color);
    else if (fits)
      // Adding 0 turns −0, which has no bit here, into 0.
      bits = smallFloatBits<6>(color.x + 0.0f) | smallFloatBits<6>(color.y + 0.0f) << 11 |
             smallFloatBits<5>(color.z + 0.0f) << 22;
    std::memcpy(bytes + 4 * i, &bits, 4);
  }
  return all_fit;
}

/// Calls `pack(channels, bytes)` for pieces of the texels, with the first `to` of red, green, blue and alpha of each.
template <typename Pack>
bool packChannels(std::span<const float> samples, std::size_t from, std::size_t to, std::span<std::uint8_t> bytes,
                  const Pack& pack) {
  assert(from != 2 || to == 2);
  constexpr std::size_t kTexels = 256;
  std::array<float, 4 * kTexels> piece;
  const std::size_t texels = samples.size() / from;
  const std::size_t texel_size = bytes.size() / std::max<std::size_t>(texels, 1);
  bool all_fit = true;
  for (std::size_t begin = 0; begin < texels; begin += kTexels) {
    const std::size_t count = std::min(kTexels, texels - begin);
    const float* texel = samples.data() + begin * from;
    for (std::size_t i = 0; i < count; ++i, texel += from) {
      for (std::size_t c = 0; c < std::min<std::size_t>(to, 3); ++c) piece[to * i + c] = texel[from == 1 ? 0 : c];
      if (to == 4) piece[4 * i + 3] = from == 4 ? texel[3] : 1.0f;
    }
    all_fit &=
        pack(std::span<const float>(piece).first(to * count), bytes.subspan(begin * texel_size, count * texel_size));
  }
  return all_fit;
}

std::span<std::uint16_t> asHalves(std::span<std::uint8_t> bytes) {
  return {reinterpret_cast<std::uint16_t*>(bytes.data()), bytes.size() / 2};
}

}  // namespace

StoredFormat storedFormat(TexelFormat format) {
  switch (format) {
    case TexelFormat::half:
      return {SampleType::half, 4};
    case TexelFormat::float32:
      return {SampleType::float32, 4};
    case TexelFormat::b10g11r11:
      return {SampleType::b10g11r11, 3};
    case TexelFormat::rg_half:
      return {SampleType::half, 2};
    case TexelFormat::rg_float32:
      return {SampleType::float32, 2};
    case TexelFormat::bc6h:
      return {SampleType::bc6h_unsigned, 3};
    case TexelFormat::uastc_hdr:
      return {SampleType::uastc_hdr, 3};
    default:
      return {SampleType::e5b9g9r9, 3};
  }
}

std::string formatName(const StoredFormat& format) {
  if (isInBits(format.type)) return nameOfBits(format) + (hasSrgbCurve(format) ? " srgb" : " unorm");
  if (format.type == SampleType::b10g11r11) return "b10g11r11 ufloat";
  if (format.type == SampleType::e5b9g9r9) return "e5b9g9r9 ufloat";
  if (format.type == SampleType::bc6h_unsigned) return "bc6h ufloat";
  if (format.type == SampleType::bc6h_signed) return "bc6h sfloat";
  if (format.type == SampleType::uastc_hdr) return "uastc hdr 4x4";
  const std::string bits = std::to_string(8 * wordSize(format));
  const std::string letters = format.blue_first ? "bgra" : "rgba";
  std::string name;
  for (std::size_t c = 0; c < std::size_t(format.channels); ++c)
    name += (c == 3 && format.ignores_fourth ? 'x' : letters[c]) + bits;
  switch (format.type) {
    case SampleType::srgb8:
      return name + " srgb";
    case SampleType::unorm8:
    case SampleType::unorm16:
      return name + " unorm";
    default:
      return name + " sfloat";
  }
}

std::size_t wordSize(const StoredFormat& format) {
  switch (format.type) {
    case SampleType::srgb_bits:
    case SampleType::unorm_bits:
      return format.word_bytes;
    case SampleType::srgb8:
    case SampleType::unorm8:
    case SampleType::bc6h_unsigned:
    case SampleType::bc6h_signed:
    case SampleType::uastc_hdr:
      return 1;
    case SampleType::unorm16:
    case SampleType::half:
      return 2;
    default:
      return 4;
  }
}

int blockSide(const StoredFormat& format) { return isCompressed(format.type) ? 4 : 1; }

std::size_t blockSize(const StoredFormat& format) {
  if (isCompressed(format.type)) return kHalfBlockSize;
  if (isInBits(format.type)) return format.word_bytes;
  return isPacked(format.type) ? 4 : wordSize(format) * std::size_t(format.channels);
}

std::uint64_t blocksAlong(const StoredFormat& format, std::uint64_t texels) {
  const auto side = static_cast<std::uint64_t>(blockSide(format));
  return (texels + side - 1) / side;
}

int imageChannels(const StoredFormat& format) {
  if (format.channels == 2 || format.ignores_fourth) return 3;
  return format.channels;
}

bool hasSrgbCurve(const StoredFormat& format) {
  return format.type == SampleType::srgb8 || format.type == SampleType::srgb_bits;
}

StoredFormat withoutCurve(StoredFormat format) {
  if (format.type == SampleType::srgb_bits) format.type = SampleType::unorm_bits;
  if (format.type == SampleType::srgb8) format.type = SampleType::unorm8;
  return format;
}

TransferCurve transferCurve(const StoredFormat& format) { return hasSrgbCurve(format) ? kSrgbCurve : kLinearLight; }

Result<Image> unpackTexels(const StoredFormat& format, const std::uint8_t* bytes, std::size_t row_pitch, int width,
                           int height) {
  Image image(width, height, imageChannels(format));
  if (format.type == SampleType::uastc_hdr) return unpackUastcHdr(bytes, row_pitch, std::move(image));
  if (isInBits(format.type)) return unpackBits(format, bytes, row_pitch, std::move(image));
  if (isBc6h(format.type)) {
    parallelFor(std::size_t(blocksAlong(format, std::uint64_t(height))), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
        decodeBc6hRow(bytes + row * row_pitch, format.type == SampleType::bc6h_signed,
                      static_cast<int>(row) * blockSide(format), image);
    });
    return image;
  }
  const std::size_t rows_per_piece = std::max<std::size_t>(kTexelsPerPiece / std::size_t(width), 1);
  parallelFor(std::size_t(height), rows_per_piece, [&](std::size_t begin, std::size_t end) {
    std::vector<float> scratch;
    for (std::size_t y = begin; y < end; ++y)
      unpackRow(format, bytes + y * row_pitch, image.row(static_cast<int>(y)), scratch);
  });
  return image;
}

bool packTexels(TexelFormat format, std::span<const float> samples, int channels, int width,
                std::span<std::uint8_t> bytes) {
  const StoredFormat stored = storedFormat(format);
  const std::size_t from = std::size_t(channels);
  const std::size_t to = std::size_t(stored.channels);
  switch (stored.type) {
    case SampleType::bc6h_unsigned:
      return encodeBc6h(samples, channels, width, bytes);
    case SampleType::uastc_hdr:
      return encodeUastcHdr(samples, channels, width, bytes);
    case SampleType::half:
      if (from == to) return halvesFromFloats(samples, asHalves(bytes));
      if (from == 3 && to == 4) return rgbaHalvesFromRgb(samples, asHalves(bytes));
      return packChannels(samples, from, to, bytes, [](std::span<const float> piece, std::span<std::uint8_t> packed) {
        return halvesFromFloats(piece, asHalves(packed));
      });
    case SampleType::float32:
      return packChannels(samples, from, to, bytes, [](std::span<const float> piece, std::span<std::uint8_t> packed) {
        std::memcpy(packed.data(), piece.data(), packed.size());
        return true;
      });
    default:
      return packPacked(format, samples, from, bytes.data());
  }
}

float maxOf(TexelFormat format) {
  switch (format) {
    case TexelFormat::half:
    case TexelFormat::rg_half:
      return 65504.0f;
    case TexelFormat::b10g11r11:
      return 64512.0f;
    case TexelFormat::e5b9g9r9:
      return 65408.0f;
    case TexelFormat::bc6h:
    case TexelFormat::uastc_hdr:
      return kLargestHalf;
    default:
      return std::numeric_limits<float>::max();
  }
}

std::size_t firstMisfit(TexelFormat format, std::span<const float> samples, int channels) {
  const auto step = static_cast<std::size_t>(channels);
  std::vector<std::uint8_t> bytes(blockSize(storedFormat(format)));
  const auto fits = [&](std::span<const float> texel) {
    return isCompressed(storedFormat(format).type) ? fitsUnsignedHalf(texel, channels)
                                                   : packTexels(format, texel, channels, 1, bytes);
  };
  std::size_t texel = 0;
  while (fits(samples.subspan(texel * step, step))) ++texel;
  return texel;
}

bool refusesNegativeLight(TexelFormat format) {
  return format == TexelFormat::b10g11r11 || format == TexelFormat::e5b9g9r9 || isCompressed(storedFormat(format).type);
}

std::string rangeOf(TexelFormat format) {
  switch (format) {
    case TexelFormat::half:
    case TexelFormat::rg_half:
      return "half floats hold -65504 to 65504";
    case TexelFormat::b10g11r11:
      return "b10g11r11 holds 0 to 65024 (blue 64512)";
    case TexelFormat::bc6h:
      return "bc6h holds 0 to 65504";
    case TexelFormat::uastc_hdr:
      return "uastc_hdr holds 0 to 65504";
    default:
      return "e5b9g9r9 holds 0 to 65408";
  }
}

}  // namespace mirrorball
