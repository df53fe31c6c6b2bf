#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/coded_file.h"

namespace mirrorball {

/// Whether the bytes begin as one of Netpbm's pictures does: P1 to P7.
bool isPnm(std::span<const std::uint8_t> bytes);

/// Decodes the first picture of a PBM, PGM, PPM (as text or as bytes) or PAM file of up to 16 bits a sample, with or
/// without alpha. Samples are taken as sRGB, as most programs write them; Netpbm's own pages name BT.709's curve. Rows
/// that the file ends before are black, with a remark.
///
/// errors   bad_file (also: no row is whole); too_large; unsupported (a PAM of another kind)
/// from     Netpbm's pages pbm(5), pgm(5), ppm(5), pam(5)
Result<CodedFile> decodePnm(std::span<const std::uint8_t> bytes, CodeForm form = CodeForm::stored);

/// Whether the bytes begin as a Portable FloatMap does.
bool isPfm(std::span<const std::uint8_t> bytes);

/// Decodes a Portable FloatMap, grey, RGB or RGBA, in either byte order: linear light, Rec.709. Rows are stored bottom
/// up. The size of the number whose sign tells the byte order is the unit of the samples: they are multiplied by it,
/// but for alpha. Its decimal comma, a header that ends with CR LF, and rows that the file ends before, which are
/// black, are reported.
///
/// errors   bad_file (also: no row is whole); too_large
/// from     P. Debevec, "Portable FloatMap Image Format"; Netpbm's page pfm(5); for alpha, libcgt's PortableFloatMapIO
Result<DecodedImage> decodePfm(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
