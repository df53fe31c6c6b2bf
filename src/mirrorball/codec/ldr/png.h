#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/coded_picture.h"

namespace mirrorball {

/// Decodes a PNG of any colour type and depth to linear light, 16-bit samples with all their
/// precision. Grey stays one channel unless it has alpha. What the file says of its colour is
/// converted (png_color.h).
///
/// errors   bad_file; too_large
Result<DecodedImage> decodePng(std::span<const std::uint8_t> bytes);

/// Decodes a PNG to 8-bit RGBA as stored.
Result<Image8> decodePngTexture(std::span<const std::uint8_t> bytes);

/// Decodes to the codes as stored, 16 bits with all their digits.
Result<CodedPicture> decodePngCodes(std::span<const std::uint8_t> bytes);

/// Encodes 1 (grey), 3 or 4 channels of 8 bits, marked as sRGB or as sRGB's curve with other primaries; metadata as
/// tEXt.
///
/// primaries  that the picture has: not ACEScg's
/// errors     too_large (memory); bad_shape (a side above 2³¹ − 1)
Result<Bytes> encodePng(const Image8& picture, const Metadata& metadata,
                        OutputPrimaries primaries = OutputPrimaries::rec709);

/// For the registry of formats.
FormatCodec pngCodec();

}  // namespace mirrorball
