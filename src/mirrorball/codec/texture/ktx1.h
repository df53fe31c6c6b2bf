#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/texture/texel_stream.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/codec/texture/texture_shape.h"

namespace mirrorball {

/// Whether the bytes begin as a KTX 1 file does.
bool isKtx1(std::span<const std::uint8_t> bytes);

/// Decodes a KTX 1 file of either byte order: uncompressed formats and BC6H.
///
/// errors   as decodeImageSet
/// from     KTX File Format Specification, version 1 (Khronos, 2013)
Result<DecodedImageSet> decodeKtx1(std::span<const std::uint8_t> bytes, ReadAs as = ReadAs::light);

/// Where the images of a KTX 1 file stand: largest level first. The header ends with the size of the first level;
/// before each of the others stands its own.
///
/// errors   too_large: that size has 32 bits
Result<TextureLayout> ktx1Layout(const TextureShape& shape, const TextureWriteOptions& options);

/// Writes such a file, as Filament's own reader takes it.
///
/// images   checked for shape already
/// errors   too_large, out_of_range; what `write` returns
Result<void> writeKtx1(const ImageSet& images, const TextureWriteOptions& options, const WriteAt& write);

}  // namespace mirrorball
