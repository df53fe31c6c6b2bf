#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes a grey or RGB JPEG, baseline or progressive, to linear light; samples are taken as sRGB. Where it has a gain
/// map (ultra_hdr.h), to the HDR light of both. A file that ends early is an error, never a picture whose rest is grey;
/// where the gain map is gone as a whole, the picture is read alone.
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

/// Encodes an Ultra HDR picture: a JPEG that every reader shows, and a gain map by which those that know of it have the
/// light itself (gain_map.h). The gain map is made for the picture as it is read again, and so corrects the picture's
/// own rounding too.
///
/// picture  as encodeJpeg's
/// light    of the picture's size, white at 1; 1, 3 or 4 channels
/// errors   as encodeJpeg's
/// cost     three times encodeJpeg's
Result<Bytes> encodeJpegWithGainMap(const Image8& picture, const Image& light, const Metadata& metadata);

/// For the registry of formats.
FormatCodec jpegCodec();

}  // namespace mirrorball
