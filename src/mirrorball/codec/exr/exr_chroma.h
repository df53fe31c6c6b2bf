#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/codec/exr/exr_part.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// Reads luminance and subsampled chroma by OpenEXR's own filter, which works in half floats. Rows that the file lacks
/// are black; those beside them take the colours that the filter wants of them from the nearest row that is there.
/// Throws, as OpenEXR does.
///
/// bytes  the file's
/// part   that has chroma
/// image  of the picture's size; receives its texels, and is left as it is where the file has none
void readExrChroma(std::span<const std::uint8_t> bytes, const ExrPart& part, Image& image);

}  // namespace mirrorball
