#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/coded_file.h"

namespace mirrorball {

/// Whether the bytes begin as a Windows or OS/2 bitmap does.
bool isBmp(std::span<const std::uint8_t> bytes);

/// Decodes a bitmap: palettes of 1, 2, 4 and 8 bits, 16, 24 and 32 bits, masks of any bits, RLE4 and RLE8, bottom up or
/// top down, of every version of the header from OS/2's to Windows' fifth. Samples are taken as sRGB. There is alpha
/// where a mask names it; the fourth byte of plain 32 bits is none. Rows that the file ends before are black, with a
/// remark.
///
/// errors   bad_file (also: no row is whole); too_large; unsupported (JPEG or PNG inside, OS/2's own
///          compressions, 64 bits)
/// from     Microsoft, "Windows GDI: Bitmap Storage" and [MS-WMF] 2.2.2.3; OS/2 2.0 Presentation Manager Reference
Result<CodedFile> decodeBmp(std::span<const std::uint8_t> bytes, CodeForm form = CodeForm::stored);

}  // namespace mirrorball
