#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Whether the bytes begin as a Radiance picture does.
bool isHdr(std::span<const std::uint8_t> bytes);

/// Decodes a Radiance picture: RGBE or XYZE; new RLE, old RLE or flat; any orientation. EXPOSURE
/// and COLORCORR are divided out, PRIMARIES converted to Rec.709; not of numbers (ReadAs).
///
/// A component is mantissa · 2^(exponent − 136). Radiance's own reader adds ½ to the mantissa, for
/// its writer truncates; stb, OpenCV, OpenImageIO and ffmpeg do not, and neither do we, whose
/// writer rounds: so 1 stays 1.
///
/// XYZE is taken as CIE XYZ with Y as it stands, seen under Rec.709's white: no white balance and
/// no division by Radiance's 179 lm/W.
///
/// Rows that the file ends before are black, with a remark.
///
/// errors   bad_file (the line or byte is named; also: no row is whole); too_large; unsupported
/// cost     O(width · height), on all cores
/// from     G. Ward, "Real Pixels", Graphics Gems II; Radiance's "File formats"
Result<DecodedImage> decodeHdr(std::span<const std::uint8_t> bytes, const ImageReadOptions& options = {});

/// Encodes the first three channels (or the one, as grey) as RGBE in new RLE. Mantissas are rounded
/// to nearest; what is negative or NaN becomes 0, and what is too bright the brightest that can be.
///
/// primaries  that the image has; the header states those that are not Rec.709's, which few parsers expect there
Bytes encodeHdr(const Image& image, const Metadata& metadata, OutputPrimaries primaries = OutputPrimaries::rec709);

}  // namespace mirrorball
