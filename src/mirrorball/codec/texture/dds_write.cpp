#include <cstdint>

#include "mirrorball/codec/little_endian_writer.h"
#include "mirrorball/codec/texture/dds.h"
#include "mirrorball/codec/texture/dds_layout.h"
#include "mirrorball/codec/texture/format_numbers.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/codec/texture/texture_shape.h"

namespace mirrorball {
namespace {

using namespace dds;

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
