#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes a JPEG XL picture, of integers of up to 16 bits or of floats, lossy or lossless, with or without alpha, to
/// linear light by what it says of its codes (color/coded_color.h), upright.
///
/// errors   bad_file; too_large; unsupported (an animation)
Result<DecodedImage> decodeJxl(std::span<const std::uint8_t> bytes);

/// Decodes one of integers to 8-bit RGBA as stored.
Result<Image8> decodeJxlTexture(std::span<const std::uint8_t> bytes);

/// Decodes one of integers to its codes, as 16 bits: 3 or 4 channels.
Result<CodedPicture> decodeJxlCodes(std::span<const std::uint8_t> bytes);

/// For the registry of formats.
FormatCodec jxlCodec();

}  // namespace mirrorball
