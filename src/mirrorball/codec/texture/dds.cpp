#include "mirrorball/codec/texture/dds.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/little_endian_writer.h"
#include "mirrorball/codec/texture/dds_layout.h"
#include "mirrorball/codec/texture/format_numbers.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/codec/texture/texture_shape.h"

namespace mirrorball {
namespace {

using namespace dds;
using Span = std::span<const std::uint8_t>;

/// What the headers say.
struct DdsHeader {
  TextureShape shape;
  StoredFormat format;
  bool encoding_assumed = false;  ///< the file does not say whether it is sRGB
  std::size_t size = 0;           ///< bytes: the texels begin here
};

constexpr const char* kDdsInstead = "R16G16B16A16_FLOAT";

/// Formats from before DX10 that have a code instead of masks: D3DFORMAT's numbers.
std::optional<StoredFormat> formatOfCode(std::uint32_t code) {
  switch (code) {
    case 36:  // D3DFMT_A16B16G16R16
      return StoredFormat{SampleType::unorm16, 4};
    case 111:  // D3DFMT_R16F
      return StoredFormat{SampleType::half, 1};
    case 112:  // D3DFMT_G16R16F
      return StoredFormat{SampleType::half, 2};
    case 113:  // D3DFMT_A16B16G16R16F
      return StoredFormat{SampleType::half, 4};
    case 114:  // D3DFMT_R32F
      return StoredFormat{SampleType::float32, 1};
    case 115:  // D3DFMT_G32R32F
      return StoredFormat{SampleType::float32, 2};
    case 116:  // D3DFMT_A32B32G32R32F
      return StoredFormat{SampleType::float32, 4};
    default:
      return {};
  }
}

/// "DXT5", or a number where the code has no letters.
std::string nameOfCode(std::uint32_t code) {
  std::string letters;
  for (int i = 0; i < 4; ++i) letters += static_cast<char>(code >> (8 * i));
  if (std::all_of(letters.begin(), letters.end(), [](unsigned char c) { return std::isalnum(c) != 0; }))
    return letters + " (block compression or another code)";
  return "the pixel format " + std::to_string(code);
}

/// Bytes one behind the other, as bit masks of red, green, blue and alpha name them.
struct MaskRow {
  std::uint32_t bits;
  std::uint32_t red, green, blue, alpha;
  StoredFormat format;
};
constexpr MaskRow kMaskRows[] = {
    {32, 0xff0000, 0xff00, 0xff, 0xff000000, {SampleType::srgb8, 4, true}},
    {32, 0xff0000, 0xff00, 0xff, 0, {SampleType::srgb8, 4, true, true}},
    {32, 0xff, 0xff00, 0xff0000, 0xff000000, {SampleType::srgb8, 4}},
    {32, 0xff, 0xff00, 0xff0000, 0, {SampleType::srgb8, 4, false, true}},
    {24, 0xff0000, 0xff00, 0xff, 0, {SampleType::srgb8, 3, true}},
    {24, 0xff, 0xff00, 0xff0000, 0, {SampleType::srgb8, 3}},
    {8, 0xff, 0, 0, 0, {SampleType::srgb8, 1}},
};

/// The format from the 32 bytes of DDS_PIXELFORMAT, for files without the DX10 header.
Result<StoredFormat> formatBeforeDx10(const std::uint8_t* pixel_format) {
  const std::uint32_t flags = littleU32(pixel_format + 4);
  const std::uint32_t code = littleU32(pixel_format + 8);
  if (flags & kPixelFourLetters) {
    const auto format = formatOfCode(code);
    if (!format) return unsupportedTexture(nameOfCode(code), kDdsInstead);
    return *format;
  }
  const std::uint32_t bits = littleU32(pixel_format + 12);
  const auto mask = [&](int channel) { return littleU32(pixel_format + 16 + 4 * channel); };
  // The alpha mask of a format without alpha may hold anything: its flag is the lowest bit.
  const std::uint32_t alpha = flags & 1u ? mask(3) : 0;
  if (flags & (kPixelRgb | kPixelLuminance))
    for (const MaskRow& row : kMaskRows)
      if (row.bits == bits && row.red == mask(0) && row.green == mask(1) && row.blue == mask(2) && row.alpha == alpha)
        return row.format;
  return unsupportedTexture("a pixel format of " + counted(bits, "bit") + " with masks of its own", kDdsInstead);
}

Result<void> readDx10Header(const std::uint8_t* dx10, DdsHeader& header) {
  const auto format = formatOfDxgi(littleU32(dx10));
  if (!format) return unsupportedTexture(nameOfDxgi(littleU32(dx10)), kDdsInstead);
  header.format = *format;
  if (littleU32(dx10 + 4) != kTexture2d)
    return unsupportedTexture("a texture that is not two-dimensional", kDdsInstead);
  if (littleU32(dx10 + 8) & kMiscCube) header.shape.faces = 6;
  header.shape.layers = littleU32(dx10 + 12);
  return {};
}

Result<DdsHeader> readDdsHeader(Span bytes) {
  if (bytes.size() < kDdsHeaderSize)
    return fail(ErrorCode::bad_file, "the header ends early, at byte " + std::to_string(bytes.size()) + " of " +
                                         std::to_string(kDdsHeaderSize) + "; the file is truncated");
  const auto u32 = [&](std::size_t at) { return littleU32(bytes.data() + at); };
  // The sizes of DDS_HEADER and of DDS_PIXELFORMAT.
  if (u32(4) != 124 || u32(76) != 32)
    return fail(ErrorCode::bad_file, "the header's sizes at bytes 4 and 76 are not 124 and 32; it is damaged");
  DdsHeader header;
  header.size = kDdsHeaderSize;
  header.shape.height = u32(12);
  header.shape.width = u32(16);
  header.shape.levels = std::max(u32(28), 1u);
  const std::uint32_t caps2 = u32(112);
  if (caps2 & kCaps2Volume) return unsupportedTexture("a three-dimensional texture", kDdsInstead);
  const bool is_dx10 = (u32(80) & kPixelFourLetters) && u32(84) == kDx10;
  if (is_dx10) {
    header.size += kDx10HeaderSize;
    if (bytes.size() < header.size)
      return fail(ErrorCode::bad_file, "the DX10 header ends early, at byte " + std::to_string(bytes.size()) + " of " +
                                           std::to_string(header.size) + "; the file is truncated");
    MIRRORBALL_TRY_VOID(readDx10Header(bytes.data() + kDdsHeaderSize, header));
  } else {
    MIRRORBALL_TRY(format, formatBeforeDx10(bytes.data() + 76));
    header.format = format;
    header.encoding_assumed = format.type == SampleType::srgb8;
    if (caps2 & kCaps2Cube) {
      if ((caps2 & kCaps2AllFaces) != kCaps2AllFaces)
        return unsupportedTexture("a cube with fewer than six faces", kDdsInstead);
      header.shape.faces = 6;
    }
  }
  MIRRORBALL_TRY_VOID(checkTextureShape(header.shape));
  return header;
}

/// Bytes of all levels of one face.
std::uint64_t chainSize(const TextureShape& shape, const StoredFormat& format) {
  std::uint64_t size = 0;
  for (std::uint32_t level = 0; level < shape.levels; ++level)
    size += imageSize(shape, format, static_cast<int>(level));
  return size;
}

Result<ImageSet> readImages(const std::uint8_t* texels, const DdsHeader& header) {
  const TextureShape& shape = header.shape;
  ImageSet images(static_cast<int>(shape.levels), static_cast<int>(shape.faces), static_cast<int>(shape.layers));
  for (int layer = 0; layer < images.layers(); ++layer)
    for (int face = 0; face < images.faces(); ++face)
      for (int level = 0; level < images.levels(); ++level) {
        const auto row = static_cast<std::size_t>(rowSize(shape, header.format, level));
        MIRRORBALL_TRY(image, unpackTexels(header.format, texels, row, shape.widthAt(level), shape.heightAt(level)));
        images.at(level, face, layer) = std::move(image);
        texels += imageSize(shape, header.format, level);
      }
  return images;
}

Bytes encodeHeader(const TextureShape& shape, TexelFormat format, bool has_alpha) {
  const bool is_cube = shape.faces == 6;
  const bool has_mips = shape.levels > 1;
  const bool is_complex = is_cube || has_mips || shape.layers > 1;
  LittleEndianWriter writer;
  writer.u32(kMagic);
  writer.u32(124);
  // Of compressed texels the size of the first level is stated, of others that of a row.
  const StoredFormat stored = storedFormat(format);
  const bool is_compressed = blockSide(stored) > 1;
  writer.u32(kHasCaps | kHasHeight | kHasWidth | kHasPixelFormat | (is_compressed ? kHasLinearSize : kHasPitch) |
             (has_mips ? kHasMipCount : 0));
  writer.u32(shape.height);
  writer.u32(shape.width);
  writer.u32(static_cast<std::uint32_t>(is_compressed ? imageSize(shape, stored, 0) : rowSize(shape, stored, 0)));
  writer.u32(0);  // no depth
  writer.u32(shape.levels);
  writer.zeros(11 * 4);
  writer.u32(32);  // DDS_PIXELFORMAT
  writer.u32(kPixelFourLetters);
  writer.u32(kDx10);
  writer.zeros(5 * 4);  // no masks
  writer.u32(kCapsTexture | (is_complex ? kCapsComplex : 0) | (has_mips ? kCapsMips : 0));
  writer.u32(is_cube ? kCaps2Cube | kCaps2AllFaces : 0);
  writer.zeros(3 * 4);
  writer.u32(dxgiNumber(format));
  writer.u32(kTexture2d);
  writer.u32(is_cube ? kMiscCube : 0);
  writer.u32(shape.layers);
  writer.u32(has_alpha ? kAlphaStraight : kAlphaOpaque);
  return writer.takeBytes();
}

}  // namespace

bool isDds(Span bytes) { return bytes.size() >= 4 && littleU32(bytes.data()) == kMagic; }

Result<DecodedImageSet> decodeDds(Span bytes) {
  MIRRORBALL_TRY(header, readDdsHeader(bytes));
  const std::uint64_t expected = chainSize(header.shape, header.format) * header.shape.imagesPerLevel();
  if (expected > bytes.size() - header.size)
    return fail(ErrorCode::bad_file, "its texels have " + std::to_string(expected) + " bytes from byte " +
                                         std::to_string(header.size) + " on, but the file has " +
                                         std::to_string(bytes.size()) + "; it is truncated or damaged");
  MIRRORBALL_TRY_VOID(checkTextureMemory(header.shape, header.format));
  const char* assumed = header.encoding_assumed ? " (assumed)" : "";
  MIRRORBALL_TRY(images, readImages(bytes.data() + header.size, header));
  return DecodedImageSet{std::move(images),
                         {},
                         "DDS, " + nameOf(header.format) + assumed,
                         describeColor(curveOf(header.format), {}, imageChannels(header.format)) + assumed};
}

TextureLayout ddsLayout(const TextureShape& shape, bool has_alpha, const TextureWriteOptions& options) {
  const StoredFormat format = storedFormat(options.format);
  const std::uint64_t chain = chainSize(shape, format);
  TextureLayout layout{encodeHeader(shape, options.format, format.channels == 4 && has_alpha), {}};
  std::uint64_t level_offset = kDdsHeaderSize + kDx10HeaderSize;
  for (int level = 0; level < static_cast<int>(shape.levels); ++level) {
    std::uint64_t offset = level_offset;
    for (int layer = 0; layer < static_cast<int>(shape.layers); ++layer)
      for (int face = 0; face < static_cast<int>(shape.faces); ++face, offset += chain)
        layout.images.push_back({level, layer, face, offset});
    level_offset += imageSize(shape, format, level);
  }
  return layout;
}

Result<void> writeDds(const ImageSet& images, const TextureWriteOptions& options, const WriteAt& write) {
  const TextureLayout layout = ddsLayout(shapeOf(images), images.at(0, 0).channels() == 4, options);
  MIRRORBALL_TRY_VOID(write(0, layout.header));
  return streamTexels(images, layout.images, options.format, write, options.progress);
}

}  // namespace mirrorball
