#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes a grey or RGB JPEG, baseline or progressive, to linear light; samples are taken as sRGB.
/// A file that ends early is an error, never a picture whose rest is grey.
///
/// errors   bad_file; too_large; unsupported (CMYK, 12 bit)
Result<DecodedImage> decodeJpeg(std::span<const std::uint8_t> bytes);

/// Decodes a JPEG to 8-bit RGBA as stored; alpha is 255.
Result<Image8> decodeJpegTexture(std::span<const std::uint8_t> bytes);

/// Encodes 1 (grey), 3 or 4 channels at quality 95 without chroma subsampling; alpha is dropped,
/// metadata stands in comments.
///
/// errors   bad_shape (a side above 65500, JPEG's limit)
Result<Bytes> encodeJpeg(const Image8& picture, const Metadata& metadata);

/// For the registry of formats.
FormatCodec jpegCodec();

}  // namespace mirrorball
