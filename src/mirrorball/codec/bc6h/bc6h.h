#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// Encodes rows of texels as rows of unsigned blocks. Columns and rows that are missing in the last block of a row or
/// column repeat their neighbours.
///
/// samples  1 (grey), 3 or 4 channels a texel; alpha is dropped
/// width    texels of a row
/// bytes    16 for each block
/// returns  fitsUnsignedHalf (half_blocks/half_rows.h): otherwise the bytes are not written
/// cost     about 0.07 µs a texel on one core with AVX-512; the same bits on every processor
bool encodeBc6h(std::span<const float> samples, int channels, int width, std::span<std::uint8_t> bytes);

/// Decodes one row of blocks.
///
/// bytes    16 for each block
/// begin    the row of the image that is the first of these; beyond the image's edges texels are dropped
/// image    of 3 channels
void decodeBc6hRow(const std::uint8_t* bytes, bool is_signed, int begin, Image& image);

}  // namespace mirrorball
