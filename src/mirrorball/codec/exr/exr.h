#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes an OpenEXR file: scan lines or tiles (the largest level), any compression and sample type. The image is the
/// layer that the file means as its picture, or the one that is asked for (exr_layer.h), in the display window
/// (exr_window.h): black outside of the data window. Numbers other than light are read as they are. Chromaticities
/// other than Rec.709's are converted. Alpha is premultiplied.
///
/// errors   bad_file (also: no row is whole); too_large; unsupported (no picture, deep data);
///          not_found (no layer of that name); interrupted (when the progress says so)
Result<DecodedImage> decodeExr(std::span<const std::uint8_t> bytes, const ImageReadOptions& options = {});

/// Encodes 1 (Y), 3 or 4 channels, and layers beside them, as scan lines with ZIP compression. Colours' primaries are
/// stated. NaN and infinity are kept; with `half`, finite values beyond ±65504 become ±65504.
///
/// errors   too_large (memory)
Result<Bytes> encodeExr(const Image& image, const ImageWriteOptions& options);

/// For the registry of formats.
FormatCodec exrCodec();

}  // namespace mirrorball
