#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// Encodes rows of texels as rows of blocks of UASTC HDR 4x4, which is ASTC HDR of 4 × 4 texels that can be turned into
/// BC6H without looking at texels. Columns and rows that are missing in the last block of a row or column repeat their
/// neighbours.
///
/// samples  1 (grey), 3 or 4 channels a texel; alpha is dropped
/// width    texels of a row
/// bytes    16 for each block
/// returns  fitsUnsignedHalf (half_blocks/half_rows.h), as of BC6H: otherwise the bytes are not written. Above 65216
///          only blocks of one colour are exact.
/// cost     about 0.3 µs a texel on one core with AVX-512; the same bits on every processor
bool encodeUastcHdr(std::span<const float> samples, int channels, int width, std::span<std::uint8_t> bytes);

/// Decodes one row of blocks.
///
/// bytes    16 for each block
/// begin    the row of the image that is the first of these; beyond the image's edges texels are dropped
/// image    of 3 channels
/// returns  the number of the first block that is none of UASTC HDR, as much other ASTC, or −1; from there on the row
///          is not decoded
int decodeUastcHdrRow(const std::uint8_t* bytes, int begin, Image& image);

}  // namespace mirrorball
