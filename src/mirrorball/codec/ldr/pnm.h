#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/coded_picture.h"

namespace mirrorball {

/// Whether the bytes begin as one of Netpbm's pictures does: P1 to P7.
bool isPnm(std::span<const std::uint8_t> bytes);

/// Decodes the first picture of a PBM, PGM, PPM (as text or as bytes) or PAM file of up to 16 bits a sample, with or
/// without alpha. Samples are taken as sRGB, as most programs write them; Netpbm's own pages name BT.709's curve.
///
/// errors   bad_file; too_large; unsupported (a PAM of another kind)
/// from     Netpbm's pages pbm(5), pgm(5), ppm(5), pam(5)
Result<DecodedImage> decodePnm(std::span<const std::uint8_t> bytes);

/// Decodes such a picture to 8-bit RGBA as stored, 16 bits rounded.
Result<Image8> decodePnmTexture(std::span<const std::uint8_t> bytes);

/// Decodes to the codes as stored, 16 bits with all their digits.
Result<CodedPicture> decodePnmCodes(std::span<const std::uint8_t> bytes);

/// Whether the bytes begin as a Portable FloatMap does.
bool isPfm(std::span<const std::uint8_t> bytes);

/// Decodes a Portable FloatMap, grey or RGB, in either byte order: linear light, Rec.709. Rows are stored bottom up.
/// The size of the number whose sign tells the byte order is the unit of the samples: they are multiplied by it.
///
/// errors   bad_file; too_large
/// from     P. Debevec, "Portable FloatMap Image Format"; Netpbm's page pfm(5)
Result<DecodedImage> decodePfm(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
