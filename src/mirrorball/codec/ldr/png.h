#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/coded_file.h"

namespace mirrorball {

/// Decodes a PNG of any colour type and depth, 16-bit samples with all their precision. Grey stays one channel unless
/// it has alpha. What the file says of its colour is in png_color.h; how it lies, and more, in its chunk eXIf. A
/// file that ends early is read as far as it goes, which is reported: rows that are missing are black and opaque.
///
/// errors   bad_file; too_large
/// from     PNG (third edition), 11.3.4.5 "eXIf"
Result<CodedFile> decodePng(std::span<const std::uint8_t> bytes, CodeForm form = CodeForm::stored);

/// Encodes 1 (grey), 3 or 4 channels of 8 bits, marked as sRGB or as sRGB's curve with other primaries; metadata as
/// tEXt.
///
/// primaries  that the picture has: not ACEScg's
/// errors     too_large (memory); bad_shape (a side above 2³¹ − 1)
Result<Bytes> encodePng(const Image8& picture, const Metadata& metadata,
                        OutputPrimaries primaries = OutputPrimaries::rec709);

/// For the registry of formats.
FormatCodec pngCodec();

}  // namespace mirrorball
