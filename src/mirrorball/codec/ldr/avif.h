#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes an AVIF picture of 8, 10 or 12 bits, the last two as 16, to 3 channels, or 4 with alpha. Its
/// properties irot and imir say how it lies; the orientation in its EXIF means nothing.
///
/// errors   bad_file; too_large; unsupported (an animation)
/// from     ISO/IEC 23008-12:2017, 6.5.10 and 6.5.12 (irot, imir), A.2.1 (EXIF's orientation)
Result<CodedFile> decodeAvif(std::span<const std::uint8_t> bytes, CodeForm form = CodeForm::stored);

/// For the registry of formats.
FormatCodec avifCodec();

}  // namespace mirrorball
