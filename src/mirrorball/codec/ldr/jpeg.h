#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes a grey, RGB or CMYK JPEG, baseline or progressive, to linear light. Where it has a gain map (ultra_hdr.h),
/// to the HDR light of both; where that is gone or damaged, the picture is read alone. What lies behind the end marker
/// means nothing else: phones keep there what they like.
///
/// errors   as decodeJpegCodes'
Result<DecodedImage> decodeJpeg(std::span<const std::uint8_t> bytes);

/// Decodes one to its codes, as far as it goes: rows of blocks that are missing or damaged are black, never the grey
/// that libjpeg leaves, and a remark says how many (jpeg_damage.h). Its EXIF says how it lies, its ICC profile what the
/// codes are. Inks (CMYK, YCCK) are mixed to RGB without their profile, with a remark.
///
/// errors   bad_file (also: no row of blocks is whole); too_large; unsupported (12 bits, lossless)
Result<CodedFile> decodeJpegCodes(std::span<const std::uint8_t> bytes, CodeForm form = CodeForm::stored);

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
