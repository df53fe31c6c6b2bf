#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// Takes bytes at a place in the file that is written; called from several threads at a time.
using WriteAt = std::function<Result<void>(std::uint64_t offset, std::span<const std::uint8_t> bytes)>;

/// An image of a set, and where its texels go.
struct PlacedImage {
  int level = 0;
  int layer = 0;
  int face = 0;
  std::uint64_t offset = 0;
};

/// Where the images of a texture file stand, and all that stands before them.
struct TextureLayout {
  Bytes header;
  std::vector<PlacedImage> images;
};

/// The error for a texel that does not fit its format.
///
/// place    of its image: "level 0, face +X"
/// samples  its channels
Error misfit(TexelFormat format, const std::string& place, glm::ivec2 texel, std::span<const float> samples);

/// Encodes images and writes them, rows tightly packed, without ever holding one of them as a whole.
///
/// placed   in the order in which texels that do not fit are named
/// progress told after each 64 KiB or, of compressed texels, each 16 KiB
/// errors   out_of_range (the first such texel is named); what `write` returns; interrupted (when `progress` says so)
/// cost     on all cores; 64 KiB of memory a thread
Result<void> streamTexels(const ImageSet& images, std::span<const PlacedImage> placed, TexelFormat format,
                          const WriteAt& write, const ProgressFunction& progress);

}  // namespace mirrorball
