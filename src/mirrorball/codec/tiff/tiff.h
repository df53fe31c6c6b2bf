#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/progress.h"
#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/coded_file.h"

namespace mirrorball {

/// Decodes the first page of a TIFF that is no preview: grey, RGB or a palette in integers of up to 16 or of 32 bits,
/// or in floats of 16, 32 or 64; in strips or tiles, texel by texel or plane by plane; plain, LZW, deflate, PackBits,
/// Zstandard, JPEG or SGI's LogLuv and LogL. The picture is turned as its tag says.
///
/// Integers are sRGB unless an ICC profile of a matrix says otherwise, floats linear light, of whose profile only the
/// primaries count; primaries that a file without one states are converted to Rec.709. Alpha is straight with integers
/// and premultiplied with floats, whatever the file has; a fourth sample that is not said to be alpha is left out.
/// LogLuv is CIE XYZ whose white is (1, 1, 1), as its own library has it. Rows that the file lacks are black, with a
/// remark.
///
/// errors   bad_file (also: no row is whole); too_large; unsupported (CMYK, CIE L*a*b*, a camera's raw
///          picture, other compressions); interrupted
/// from     Adobe, "TIFF Revision 6.0" (1992); G. W. Larson, "LogLuv Encoding for Full Gamut, High Dynamic Range
///          Images" (1998)
Result<DecodedImage> decodeTiff(std::span<const std::uint8_t> bytes, const ImageReadOptions& options = {});

/// Decodes a TIFF of integers to its codes, alpha straight; those of more than 16 bits are rounded.
///
/// errors   also unsupported: it has floats
Result<CodedFile> decodeTiffCodes(std::span<const std::uint8_t> bytes, CodeForm form = CodeForm::stored);

/// Whether a TIFF holds integers, and so can be a texture or the codes of a photograph.
bool isTiffOfIntegers(std::span<const std::uint8_t> bytes);

/// For the registry of formats.
FormatCodec tiffCodec();

}  // namespace mirrorball
