#include <cstring>
#include <numeric>

#include "mirrorball/codec/little_endian_writer.h"
#include "mirrorball/codec/texture/data_format_descriptor.h"
#include "mirrorball/codec/texture/format_numbers.h"
#include "mirrorball/codec/texture/ktx2.h"
#include "mirrorball/codec/texture/ktx2_layout.h"
#include "mirrorball/codec/texture/ktx_key_values.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/codec/texture/texture_shape.h"
#include "mirrorball/codec/texture/zstandard.h"

namespace mirrorball {
namespace {

/// Where a level stands, once that is known.
struct Level {
  std::uint64_t offset = 0;
  std::uint64_t size = 0;
  std::uint64_t unpacked_size = 0;
};

/// All that stands before the texels.
Bytes ktx2Header(const TextureShape& shape, const TextureWriteOptions& options, std::span<const Level> levels) {
  const Bytes descriptor = dataFormatDescriptor(options.format, options.primaries);
  const Bytes key_values = ktxKeyValues(options.metadata, KtxVersion::ktx2);
  const std::size_t descriptor_at = kKtx2HeaderSize + levels.size() * kKtx2LevelSize;
  LittleEndianWriter writer;
  writer.append(kKtx2Identifier);
  writer.u32(vulkanNumber(options.format));
  writer.u32(static_cast<std::uint32_t>(wordSize(storedFormat(options.format))));
  writer.u32(shape.width);
  writer.u32(shape.height);
  writer.u32(0);  // not three-dimensional
  writer.u32(shape.layers > 1 ? shape.layers : 0);
  writer.u32(shape.faces);
  writer.u32(shape.levels);
  writer.u32(options.zstandard_level > 0 ? kKtx2Zstandard : kKtx2Plain);
  writer.u32(static_cast<std::uint32_t>(descriptor_at));
  writer.u32(static_cast<std::uint32_t>(descriptor.size()));
  writer.u32(static_cast<std::uint32_t>(descriptor_at + descriptor.size()));
  writer.u32(static_cast<std::uint32_t>(key_values.size()));
  writer.u64(0);  // no supercompression global data
  writer.u64(0);
  for (const Level& level : levels) {
    writer.u64(level.offset);
    writer.u64(level.size);
    writer.u64(level.unpacked_size);
  }
  writer.append(descriptor);
  writer.append(key_values);
  return writer.takeBytes();
}

/// The images of one level in the order of the file, from `offset` on.
void placeLevel(const TextureShape& shape, const StoredFormat& format, int level, std::uint64_t offset,
                std::vector<PlacedImage>& placed) {
  for (int layer = 0; layer < static_cast<int>(shape.layers); ++layer)
    for (int face = 0; face < static_cast<int>(shape.faces); ++face) {
      placed.push_back({level, layer, face, offset});
      offset += imageSize(shape, format, level);
    }
}

/// Compresses level by level: where one begins is only known when the smaller ones are written.
Result<void> compressLevels(const ImageSet& images, const TextureShape& shape, const TextureWriteOptions& options,
                            std::uint64_t begin, std::span<Level> levels, const WriteAt& write) {
  const StoredFormat stored = storedFormat(options.format);
  const auto bytesOf = [&](std::size_t level) {
    return std::size_t(imageSize(shape, stored, static_cast<int>(level)) * shape.imagesPerLevel());
  };
  std::size_t all = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) all += bytesOf(i);
  std::size_t done = 0;
  std::uint64_t at = begin;
  for (std::size_t i = levels.size(); i-- > 0;) {
    const int level = static_cast<int>(i);
    Bytes texels(bytesOf(i));
    std::vector<PlacedImage> placed;
    placeLevel(shape, stored, level, 0, placed);
    const WriteAt keep = [&](std::uint64_t offset, std::span<const std::uint8_t> bytes) -> Result<void> {
      std::memcpy(texels.data() + offset, bytes.data(), bytes.size());
      return {};
    };
    // Next to the compression nothing else counts.
    const ProgressFunction asked = partOf(options.progress, done, 0, all);
    MIRRORBALL_TRY_VOID(streamTexels(images, placed, options.format, keep, asked));
    const ProgressFunction packing = partOf(options.progress, done, texels.size(), all);
    MIRRORBALL_TRY(packed, packZstandard(texels, options.zstandard_level, packing));
    done += texels.size();
    MIRRORBALL_TRY_VOID(write(at, packed));
    levels[i] = {at, packed.size(), texels.size()};
    at += packed.size();
  }
  return {};
}

}  // namespace

TextureLayout ktx2Layout(const TextureShape& shape, const TextureWriteOptions& options) {
  const StoredFormat stored = storedFormat(options.format);
  const std::uint64_t alignment = std::lcm(blockSize(stored), std::size_t{4});
  std::vector<Level> levels(shape.levels);
  std::uint64_t at = ktx2Header(shape, options, levels).size();
  for (std::size_t i = levels.size(); i-- > 0;) {
    at = (at + alignment - 1) / alignment * alignment;
    const std::uint64_t size = imageSize(shape, stored, static_cast<int>(i)) * shape.imagesPerLevel();
    levels[i] = {at, size, size};
    at += size;
  }
  TextureLayout layout{ktx2Header(shape, options, levels), {}};
  for (std::size_t i = 0; i < levels.size(); ++i)
    placeLevel(shape, stored, static_cast<int>(i), levels[i].offset, layout.images);
  return layout;
}

Result<void> writeKtx2(const ImageSet& images, const TextureWriteOptions& options, const WriteAt& write) {
  const TextureShape shape = shapeOf(images);
  if (options.zstandard_level == 0) {
    const TextureLayout layout = ktx2Layout(shape, options);
    MIRRORBALL_TRY_VOID(write(0, layout.header));
    return streamTexels(images, layout.images, options.format, write, options.progress);
  }
  std::vector<Level> levels(shape.levels);
  const std::uint64_t begin = ktx2Header(shape, options, levels).size();
  MIRRORBALL_TRY_VOID(compressLevels(images, shape, options, begin, levels, write));
  return write(0, ktx2Header(shape, options, levels));
}

}  // namespace mirrorball
