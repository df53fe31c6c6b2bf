#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/texture/texel_stream.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/codec/texture/texture_shape.h"

namespace mirrorball {

/// Whether the bytes begin as a DirectDraw surface does.
bool isDds(std::span<const std::uint8_t> bytes);

/// Decodes a DDS file, with the DX10 header or from before it (by four-letter code or by bit masks). 8-bit files from
/// before DX10 do not say how they are encoded: they are taken as sRGB, like PNG. Headers that programs are known to
/// write wrongly are read as they are meant, which the number of texels tells (docs/files.md).
///
/// errors   as decodeImageSet
/// from     Microsoft, "Programming Guide for DDS" and "DDS_HEADER_DXT10"
Result<DecodedImageSet> decodeDds(std::span<const std::uint8_t> bytes, ReadAs as = ReadAs::light);

/// Where the images of a DDS file with the DX10 header stand: by layer, face, level. Metadata is dropped.
TextureLayout ddsLayout(const TextureShape& shape, bool has_alpha, const TextureWriteOptions& options);

/// Writes such a file.
///
/// images   checked for shape already
/// errors   out_of_range; what `write` returns
Result<void> writeDds(const ImageSet& images, const TextureWriteOptions& options, const WriteAt& write);

}  // namespace mirrorball
