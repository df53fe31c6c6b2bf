#include <algorithm>
#include <limits>

#include "mirrorball/codec/little_endian_writer.h"
#include "mirrorball/codec/texture/ktx1.h"
#include "mirrorball/codec/texture/ktx1_layout.h"
#include "mirrorball/codec/texture/ktx_key_values.h"
#include "mirrorball/codec/texture/stored_format.h"

namespace mirrorball {
namespace {

using namespace ktx1;

/// A format under OpenGL's names for it.
struct GlFormatRow {
  TexelFormat format;
  std::uint32_t type;
  std::uint32_t type_size;
  std::uint32_t gl_format;
  std::uint32_t internal_format;
  std::uint32_t base_internal_format;
};
constexpr GlFormatRow kGlFormatRows[] = {
    {TexelFormat::half, kHalfFloat, 2, kRgba, kRgba16F, kRgba},
    {TexelFormat::float32, kFloat, 4, kRgba, kRgba32F, kRgba},
    // The type should be GL_UNSIGNED_INT_10F_11F_11F_REV. Filament, for which such files are, looks for what its cmgen
    // writes instead, and takes nothing else (ktxreader, toPixelDataType; tried with filament.js 1.53.4).
    {TexelFormat::b10g11r11, kR11FG11FB10F, 4, kRgb, kR11FG11FB10F, kRgb},
    {TexelFormat::e5b9g9r9, kUnsignedInt5999Rev, 4, kRgb, kRgb9E5, kRgb},
    {TexelFormat::bc6h, 0, 1, 0, kRgbBptcUnsignedFloat, kRgb},
    {TexelFormat::rg_half, kHalfFloat, 2, kRg, kRg16F, kRg},
    {TexelFormat::rg_float32, kFloat, 4, kRg, kRg32F, kRg},
};

/// The size that stands before a level: of a cube that is no array, that of one face.
std::uint64_t statedSize(const TextureShape& shape, const StoredFormat& format, int level) {
  const bool is_plain_cube = shape.faces == 6 && shape.layers == 1;
  return imageSize(shape, format, level) * (is_plain_cube ? 1 : shape.imagesPerLevel());
}

/// All that stands before the texels of the first level.
Bytes ktx1Header(const TextureShape& shape, const TextureWriteOptions& options) {
  const GlFormatRow& row = *std::find_if(std::begin(kGlFormatRows), std::end(kGlFormatRows),
                                         [&](const GlFormatRow& r) { return r.format == options.format; });
  const Bytes key_values = ktxKeyValues(options.metadata, KtxVersion::ktx1);
  LittleEndianWriter writer;
  writer.append(kIdentifier);
  writer.u32(kByteOrder);
  writer.u32(row.type);
  writer.u32(row.type_size);
  writer.u32(row.gl_format);
  writer.u32(row.internal_format);
  writer.u32(row.base_internal_format);
  writer.u32(shape.width);
  writer.u32(shape.height);
  writer.u32(0);  // not three-dimensional
  writer.u32(shape.layers > 1 ? shape.layers : 0);
  writer.u32(shape.faces);
  writer.u32(shape.levels);
  writer.u32(static_cast<std::uint32_t>(key_values.size()));
  writer.append(key_values);
  writer.u32(static_cast<std::uint32_t>(statedSize(shape, storedFormat(options.format), 0)));
  return writer.takeBytes();
}

}  // namespace

Result<TextureLayout> ktx1Layout(const TextureShape& shape, const TextureWriteOptions& options) {
  const StoredFormat stored = storedFormat(options.format);
  if (statedSize(shape, stored, 0) > std::numeric_limits<std::uint32_t>::max())
    return fail(ErrorCode::too_large, "a level of a KTX file has at most 4 GiB; use .ktx2");
  // All formats that are written have texels of a multiple of four bytes: nothing has to be aligned.
  TextureLayout layout{ktx1Header(shape, options), {}};
  std::uint64_t at = layout.header.size();
  for (int level = 0; level < static_cast<int>(shape.levels); ++level) {
    if (level > 0) at += sizeof(std::uint32_t);
    for (int layer = 0; layer < static_cast<int>(shape.layers); ++layer)
      for (int face = 0; face < static_cast<int>(shape.faces); ++face) {
        layout.images.push_back({level, layer, face, at});
        at += imageSize(shape, stored, level);
      }
  }
  return layout;
}

Result<void> writeKtx1(const ImageSet& images, const TextureWriteOptions& options, const WriteAt& write) {
  const TextureShape shape = shapeOf(images);
  MIRRORBALL_TRY(layout, ktx1Layout(shape, options));
  MIRRORBALL_TRY_VOID(write(0, layout.header));
  for (int level = 1; level < images.levels(); ++level) {
    LittleEndianWriter size;
    size.u32(static_cast<std::uint32_t>(statedSize(shape, storedFormat(options.format), level)));
    const std::uint64_t begin = layout.images[std::size_t(level) * shape.imagesPerLevel()].offset;
    MIRRORBALL_TRY_VOID(write(begin - sizeof(std::uint32_t), size.takeBytes()));
  }
  return streamTexels(images, layout.images, options.format, write, options.progress);
}

}  // namespace mirrorball
