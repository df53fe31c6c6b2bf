#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes an AVIF picture of 8, 10 or 12 bits, with or without alpha, to linear light by what it says of its codes
/// (color/coded_color.h), upright as it says.
///
/// errors   bad_file; too_large; unsupported (an animation)
Result<DecodedImage> decodeAvif(std::span<const std::uint8_t> bytes);

/// Decodes one to 8-bit RGBA as stored.
Result<Image8> decodeAvifTexture(std::span<const std::uint8_t> bytes);

/// Decodes one to its codes: 3 or 4 channels; of 10 and 12 bits as 16.
Result<CodedPicture> decodeAvifCodes(std::span<const std::uint8_t> bytes);

/// For the registry of formats.
FormatCodec avifCodec();

}  // namespace mirrorball
