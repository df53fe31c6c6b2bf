#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes a JPEG XL picture, of integers of up to 16 bits or of floats, lossy or lossless, with or without alpha, to
/// linear light by what it says of its codes (color/coded_color.h), upright. That is made of floats, for libjxl's of a
/// lossy picture have more digits than its codes. Its codestream says how it lies; EXIF's orientation means nothing.
///
/// errors   bad_file; too_large; unsupported (an animation)
/// from     ISO/IEC 18181-1:2022, annex D.3 (orientation); 18181-2:2021, 9.4 (Exif)
Result<DecodedImage> decodeJxl(std::span<const std::uint8_t> bytes, const ImageReadOptions& options = {});

/// Decodes one of integers to its codes of 8 bits, or of 16 if it has more: 3 or 4 channels.
Result<CodedFile> decodeJxlCodes(std::span<const std::uint8_t> bytes, CodeForm form = CodeForm::stored);

/// For the registry of formats.
FormatCodec jxlCodec();

}  // namespace mirrorball
