#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes a WebP picture, lossy or lossless, with or without alpha; samples are taken as sRGB.
///
/// errors   bad_file; too_large; unsupported (an animation)
Result<DecodedImage> decodeWebp(std::span<const std::uint8_t> bytes);

/// Decodes a WebP to 8-bit RGBA as stored.
Result<Image8> decodeWebpTexture(std::span<const std::uint8_t> bytes);

/// For the registry of formats.
FormatCodec webpCodec();

}  // namespace mirrorball
