#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes an OpenEXR file: scan lines or tiles (the largest level), any compression and sample
/// type. The image is the data window of the first part that has colour: R G B (A), else luminance
/// and chroma, else Y (one channel; with A, four); else the same in the first layer that has them
/// ("layer.R"). Chromaticities other than Rec.709's are converted. Alpha is premultiplied.
///
/// errors   bad_file (also when part of the texels is missing); too_large; unsupported (no colour,
///          deep data); interrupted (when the progress says so)
Result<DecodedImage> decodeExr(std::span<const std::uint8_t> bytes, const ImageReadOptions& options = {});

/// Encodes 1 (Y), 3 or 4 channels, and layers beside them, as scan lines with ZIP compression. Colours' primaries are
/// stated. NaN and infinity are kept; with `half`, finite values beyond ±65504 become ±65504.
///
/// errors   too_large (memory)
Result<Bytes> encodeExr(const Image& image, const ImageWriteOptions& options);

/// For the registry of formats.
FormatCodec exrCodec();

}  // namespace mirrorball
