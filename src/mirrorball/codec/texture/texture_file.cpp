#include "mirrorball/codec/texture/texture_file.h"

#include <cassert>
#include <memory>

#include "mirrorball/base/range.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/metadata.h"
#include "mirrorball/codec/texture/dds.h"
#include "mirrorball/codec/texture/ktx1.h"
#include "mirrorball/codec/texture/ktx2.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/codec/texture/texture_shape.h"
#include "mirrorball/codec/texture/zstandard.h"
#include "mirrorball/codec/within_memory.h"

namespace mirrorball {
namespace {

constexpr int kHighestZstandardLevel = 22;

Result<DecodedImageSet> decodeByMagic(std::span<const std::uint8_t> bytes, ReadAs as) {
  if (isKtx2(bytes)) return decodeKtx2(bytes, as);
  if (isKtx1(bytes)) return decodeKtx1(bytes, as);
  if (isDds(bytes)) return decodeDds(bytes, as);
  return fail(ErrorCode::bad_file, "does not begin as a KTX2, KTX or DDS texture does");
}

std::string shapeText(const Image& image) {
  return sizeText({image.width(), image.height()}) + " with " + counted(std::size_t(image.channels()), "channel");
}

/// All images have the size that their level makes them, and the channels of the first, which the format can hold.
Result<void> checkShape(const ImageSet& images, TexelFormat format) {
  if (images.empty() || images.at(0, 0).empty())
    return fail(ErrorCode::bad_shape, "a texture of no texels cannot be written");
  const Image& first = images.at(0, 0);
  if (first.channels() == 2 && storedFormat(format).channels != 2)
    return fail(ErrorCode::bad_shape,
                "a texture of 2 channels needs a format of two; give it one, or 1, 3 or 4 channels");
  auto shape = checkTextureShape(shapeOf(images));
  if (!shape) return fail(ErrorCode::bad_shape, std::move(shape.error().message));
  for (int level = 0; level < images.levels(); ++level)
    for (int layer = 0; layer < images.layers(); ++layer)
      for (int face = 0; face < images.faces(); ++face) {
        const Image& image = images.at(level, face, layer);
        if (image.width() == levelSide(first.width(), level) && image.height() == levelSide(first.height(), level) &&
            image.channels() == first.channels())
          continue;
        return fail(ErrorCode::bad_shape, placeName(shapeOf(images), level, layer, face) + " is " + shapeText(image) +
                                              ", which does not go with level 0 of " + shapeText(first));
      }
  return {};
}

/// The container that a name stands for, if it can hold what is asked for.
Result<ImageFormatId> containerFor(const std::filesystem::path& path, const TextureWriteOptions& options) {
  const std::string name = path.string();
  MIRRORBALL_TRY(container, formatToWrite(path, {Holds::texture}));
  if (options.zstandard_level < 0 || options.zstandard_level > kHighestZstandardLevel)
    return fail(ErrorCode::usage, name + ": there is no Zstandard level " + std::to_string(options.zstandard_level) +
                                      "; use 0 (none) to " + std::to_string(kHighestZstandardLevel));
  if (container != ImageFormatId::ktx2 && options.zstandard_level > 0)
    return fail(ErrorCode::usage, name + ": has no Zstandard compression; use .ktx2");
  if (container != ImageFormatId::ktx2 && !holdsFormat(extensionOf(path), options.format))
    return fail(ErrorCode::usage,
                name + ": cannot hold " + formatName(storedFormat(options.format)) + " texels; use .ktx2");
  MIRRORBALL_TRY_VOID(checkStatesPrimaries(path, options.primaries, {Holds::texture}));
  if (options.zstandard_level > 0) MIRRORBALL_TRY_VOID(withName(name, checkZstandard()));
  MIRRORBALL_TRY_VOID(checkMetadata(options.metadata));
  return container;
}

/// The container that takes these images.
Result<ImageFormatId> containerOf(const std::filesystem::path& path, const ImageSet& images,
                                  const TextureWriteOptions& options) {
  MIRRORBALL_TRY(container, containerFor(path, options));
  MIRRORBALL_TRY_VOID(withName(path.string(), checkShape(images, options.format)));
  return container;
}

Result<TextureLayout> layoutIn(ImageFormatId container, const TextureShape& shape, int channels,
                               const TextureWriteOptions& options) {
  if (container == ImageFormatId::dds) return ddsLayout(shape, channels == 4, options);
  if (container == ImageFormatId::ktx) return ktx1Layout(shape, options);
  return ktx2Layout(shape, options);
}

Result<void> writeIn(ImageFormatId container, const ImageSet& images, const TextureWriteOptions& options,
                     const WriteAt& write) {
  if (container == ImageFormatId::dds) return writeDds(images, options, write);
  if (container == ImageFormatId::ktx) return writeKtx1(images, options, write);
  return writeKtx2(images, options, write);
}

}  // namespace

bool holdsFormat(std::string_view extension, TexelFormat format) {
  const auto* const found = findBy(kTexelFormatNames, format, &TexelFormatName::format);
  const bool is_named = found != kTexelFormatNames.end();
  if (extension == "exr") return is_named && found->is_in_exr;
  return extension == "ktx2" || !is_named || !found->is_only_in_ktx2;
}

std::vector<std::string_view> texelFormatNames(std::string_view extension) {
  std::vector<std::string_view> names;
  for (const TexelFormatName& format : kTexelFormatNames)
    if (extension.empty() || holdsFormat(extension, format.format)) names.push_back(format.name);
  return names;
}

Result<DecodedImageSet> readImageSet(const std::filesystem::path& path) {
  MIRRORBALL_TRY(bytes, readFile(path));
  return withName(path.string(), decodeImageSet(bytes));
}

Result<DecodedImageSet> decodeImageSet(std::span<const std::uint8_t> bytes, ReadAs as) {
  return withinMemory<DecodedImageSet>([&] { return decodeByMagic(bytes, as); });
}

bool isImageSet(std::span<const std::uint8_t> bytes) { return isKtx2(bytes) || isKtx1(bytes) || isDds(bytes); }

Result<void> writeImageSet(const std::filesystem::path& path, const ImageSet& images,
                           const TextureWriteOptions& options) {
  MIRRORBALL_TRY_VOID(containerOf(path, images, options));
  MIRRORBALL_TRY(writer, FileWriter::create(path));
  MIRRORBALL_TRY_VOID(writeImageSet(writer, images, options));
  return withName(path.string(), writer.commit());
}

Result<void> writeImageSet(const FileWriter& file, const ImageSet& images, const TextureWriteOptions& options) {
  MIRRORBALL_TRY(container, containerOf(file.name(), images, options));
  const WriteAt write = [&](std::uint64_t offset, std::span<const std::uint8_t> bytes) {
    return file.writeAt(offset, bytes);
  };
  return withName(file.name(), withinMemory<void>([&] { return writeIn(container, images, options, write); }));
}

Result<TextureWriter> TextureWriter::create(const std::filesystem::path& path, glm::ivec2 size, int faces, int channels,
                                            const TextureWriteOptions& options) {
  MIRRORBALL_TRY(container, containerFor(path, options));
  assert(options.zstandard_level == 0);
  const TextureShape shape{.width = static_cast<std::uint32_t>(size.x),
                           .height = static_cast<std::uint32_t>(size.y),
                           .faces = static_cast<std::uint32_t>(faces)};
  const std::string name = path.string();
  MIRRORBALL_TRY_VOID(withName(name, checkTextureShape(shape)));
  MIRRORBALL_TRY(layout, withName(name, layoutIn(container, shape, channels, options)));
  MIRRORBALL_TRY(file, FileWriter::create(path));
  MIRRORBALL_TRY_VOID(withName(name, file.writeAt(0, layout.header)));
  TextureWriter writer(std::move(file), size, options.format);
  for (const PlacedImage& image : layout.images) writer.offsets_.push_back(image.offset);
  return writer;
}

Result<void> TextureWriter::writeTexels(int face, glm::ivec2 begin, const Image& texels) const {
  const StoredFormat stored = storedFormat(format_);
  [[maybe_unused]] const glm::ivec2 end = begin + glm::ivec2(texels.width(), texels.height());
  assert(begin % blockSide(stored) == glm::ivec2(0));
  assert((end.x % blockSide(stored) == 0 || end.x == size_.x) && (end.y % blockSide(stored) == 0 || end.y == size_.y));
  const std::size_t row_bytes = std::size_t(blocksAlong(stored, std::uint64_t(texels.width()))) * blockSize(stored);
  const auto rows = static_cast<std::size_t>(blocksAlong(stored, std::uint64_t(texels.height())));
  const auto bytes = bytesWithoutValues(row_bytes * rows);
  const std::span<std::uint8_t> packed(bytes.get(), row_bytes * rows);
  if (!packTexels(format_, texels.samples(), texels.channels(), texels.width(), packed)) {
    const std::size_t index = firstMisfit(format_, texels.samples(), texels.channels());
    const glm::ivec2 texel(index % std::size_t(texels.width()), index / std::size_t(texels.width()));
    const TextureShape shape{.faces = static_cast<std::uint32_t>(offsets_.size())};
    return tl::unexpected<Error>(misfit(format_, placeName(shape, 0, 0, face), begin + texel,
                                        {texels.texel(texel.x, texel.y), std::size_t(texels.channels())}));
  }
  const auto offsetOf = [&](std::size_t row) {
    const std::uint64_t rows_above = blocksAlong(stored, std::uint64_t(begin.y)) + row;
    return offsets_[std::size_t(face)] +
           (rows_above * blocksAlong(stored, std::uint64_t(size_.x)) + blocksAlong(stored, std::uint64_t(begin.x))) *
               blockSize(stored);
  };
  // Rows as wide as the image follow each other in the file.
  if (texels.width() == size_.x) return file_.writeAt(offsetOf(0), packed);
  for (std::size_t row = 0; row < rows; ++row)
    MIRRORBALL_TRY_VOID(file_.writeAt(offsetOf(row), packed.subspan(row * row_bytes, row_bytes)));
  return {};
}

bool isTexturePath(const std::filesystem::path& path) { return formatToWrite(path, {Holds::texture}).has_value(); }

}  // namespace mirrorball
