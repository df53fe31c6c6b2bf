#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/coded_file.h"

namespace mirrorball {

/// Whether the bytes are a TGA: they end as one of version 2 does, or begin with a header each of whose numbers is one
/// that TGA has. The format has no first bytes of its own; the type of the picture, of which six values out of 256 are
/// used, and the bits of a texel keep texts and other formats out.
bool isTga(std::span<const std::uint8_t> bytes);

/// Decodes a TGA, plain or run-length coded, of 8-bit grey (with or without alpha), a palette, or 15, 16, 24 or 32
/// bits, whichever corner it begins at. Samples are taken as sRGB. Alpha is what the header says is alpha, unless all
/// of it is 0; premultiplied where the extension area says so. Rows that the file ends before are black, with a remark.
///
/// errors   bad_file (also: no row is whole); too_large
/// from     Truevision TGA File Format Specification, version 2.0 (1991)
Result<CodedFile> decodeTga(std::span<const std::uint8_t> bytes, CodeForm form = CodeForm::stored);

}  // namespace mirrorball
