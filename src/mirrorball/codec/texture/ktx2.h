#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/texture/texel_stream.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/codec/texture/texture_shape.h"

namespace mirrorball {

/// Whether the bytes begin as a KTX 2 file does.
bool isKtx2(std::span<const std::uint8_t> bytes);

/// Decodes a KTX 2 file: uncompressed formats, BC6H and UASTC HDR 4x4, as they are or under Zstandard.
///
/// errors   as decodeImageSet
/// from     KTX 2.0 specification (Khronos, 2020)
Result<DecodedImageSet> decodeKtx2(std::span<const std::uint8_t> bytes, ReadAs as = ReadAs::light);

/// Where the images of a KTX 2 file without Zstandard stand: levels smallest first, each at a multiple of its
/// texel's or block's size and of 4; orientation "rd".
TextureLayout ktx2Layout(const TextureShape& shape, const TextureWriteOptions& options);

/// Writes such a file, or one whose levels are compressed and follow each other without gaps.
///
/// images   checked for shape already
/// errors   out_of_range; what `write` returns; too_large (memory for a level that is compressed)
Result<void> writeKtx2(const ImageSet& images, const TextureWriteOptions& options, const WriteAt& write);

}  // namespace mirrorball
