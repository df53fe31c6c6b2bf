#include "mirrorball/codec/texture/texture_shape.h"

#include <algorithm>
#include <bit>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"

namespace mirrorball {

Result<void> checkTextureShape(const TextureShape& shape) {
  MIRRORBALL_TRY_VOID(checkDimensions(shape.width, shape.height));
  const auto max_levels = static_cast<std::uint32_t>(std::bit_width(std::max(shape.width, shape.height)));
  if (shape.levels == 0 || shape.levels > max_levels)
    return fail(ErrorCode::bad_file, "says it has " + std::to_string(shape.levels) + " mip levels; a texture of " +
                                         std::to_string(shape.width) + "x" + std::to_string(shape.height) +
                                         " has 1 to " + std::to_string(max_levels));
  if (shape.faces != 1 && shape.faces != 6)
    return fail(ErrorCode::bad_file, "says it has " + std::to_string(shape.faces) + " faces; a cube has 6, all else 1");
  if (shape.faces == 6 && shape.width != shape.height)
    return fail(ErrorCode::bad_file, "says it is a cube of " + std::to_string(shape.width) + "x" +
                                         std::to_string(shape.height) + "; a cube's faces are square");
  if (shape.layers == 0)
    return fail(ErrorCode::bad_file, "says it is an array of no layers; an array has at least one");
  if (shape.layers > kMaxLayers)
    return fail(ErrorCode::too_large, "says it has " + std::to_string(shape.layers) + " layers; at most " +
                                          std::to_string(kMaxLayers) + " are read");
  return {};
}

Result<void> checkTextureMemory(const TextureShape& shape, const StoredFormat& format) {
  std::uint64_t texels = 0;
  for (int level = 0; level < static_cast<int>(shape.levels); ++level)
    texels += std::uint64_t(shape.widthAt(level)) * std::uint64_t(shape.heightAt(level)) * shape.imagesPerLevel();
  return checkMemory(texels * std::uint64_t(imageChannels(format)) * sizeof(float));
}

TextureShape shapeOf(const ImageSet& images) {
  const Image& first = images.at(0, 0);
  return {static_cast<std::uint32_t>(first.width()), static_cast<std::uint32_t>(first.height()),
          static_cast<std::uint32_t>(images.levels()), static_cast<std::uint32_t>(images.layers()),
          static_cast<std::uint32_t>(images.faces())};
}

std::uint64_t rowSize(const TextureShape& shape, const StoredFormat& format, int level) {
  return blocksAlong(format, std::uint64_t(shape.widthAt(level))) * blockSize(format);
}

std::uint64_t imageSize(const TextureShape& shape, const StoredFormat& format, int level, std::size_t row_alignment) {
  const std::uint64_t row = rowSize(shape, format, level);
  const std::uint64_t pitch = (row + row_alignment - 1) / row_alignment * row_alignment;
  return pitch * blocksAlong(format, std::uint64_t(shape.heightAt(level)));
}

std::string levelsRemark(std::uint32_t stated, std::uint32_t there) {
  return "counts " + counted(stated, "mip level") + ", and has texels for " + std::to_string(there) + ": read so";
}

std::uint64_t chainSize(const TextureShape& shape, const StoredFormat& format, std::size_t row_alignment) {
  std::uint64_t size = 0;
  for (std::uint32_t level = 0; level < shape.levels; ++level)
    size += imageSize(shape, format, static_cast<int>(level), row_alignment);
  return size;
}

std::string placeName(const TextureShape& shape, int level, int layer, int face) {
  constexpr const char* kFaces[] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  std::string place = "level " + std::to_string(level);
  if (shape.layers > 1) place += ", layer " + std::to_string(layer);
  if (shape.faces == 6) place += std::string(", face ") + kFaces[face];
  return place;
}

}  // namespace mirrorball
