#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/texture/stored_format.h"

namespace mirrorball {

/// How many images a texture has, and how large they are. Numbers as files state them, before anything is checked.
struct TextureShape {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t levels = 1;
  std::uint32_t layers = 1;
  std::uint32_t faces = 1;

  int widthAt(int level) const { return levelSide(static_cast<int>(width), level); }
  int heightAt(int level) const { return levelSide(static_cast<int>(height), level); }
  /// Images of one level.
  std::size_t imagesPerLevel() const { return std::size_t(layers) * faces; }
};

/// Refuses what no texture may be, so that products of its numbers with a texel's size fit 64 bits: more levels than
/// halvings, other than 1 or 6 faces, a cube that is not square, more than `kMaxLayers`.
///
/// errors   bad_file; too_large
Result<void> checkTextureShape(const TextureShape& shape);

/// Refuses a texture whose images, in linear light, would take more memory than may be used (base/memory.h).
///
/// errors   too_large
Result<void> checkTextureMemory(const TextureShape& shape, const StoredFormat& format);

/// Above what any graphics interface takes, and small enough to count with.
inline constexpr std::uint32_t kMaxLayers = 1u << 16;

/// The shape of a set whose images have been checked.
TextureShape shapeOf(const ImageSet& images);

/// Bytes of one row of an image's blocks, or texels where they are not compressed.
std::uint64_t rowSize(const TextureShape& shape, const StoredFormat& format, int level);

/// Bytes of one image whose rows are multiples of `row_alignment` bytes.
std::uint64_t imageSize(const TextureShape& shape, const StoredFormat& format, int level,
                        std::size_t row_alignment = 1);

/// Bytes of all levels of one face, largest first.
std::uint64_t chainSize(const TextureShape& shape, const StoredFormat& format, std::size_t row_alignment = 1);

/// The remark on a file that ends before its smallest levels, or counts some that it does not hold.
std::string levelsRemark(std::uint32_t stated, std::uint32_t there);

/// "level 2, layer 3, face +X", as far as the texture has such.
std::string placeName(const TextureShape& shape, int level, int layer, int face);

}  // namespace mirrorball
