#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Decodes a WebP picture, lossy or lossless, with or without alpha; its chunks ICCP and EXIF say what its samples are
/// and how it lies. Rows that the file ends before are black, with a remark.
///
/// errors   bad_file (also: no row is whole); too_large; unsupported (an animation)
/// from     Google, "WebP Container Specification"
Result<CodedFile> decodeWebp(std::span<const std::uint8_t> bytes, CodeForm form = CodeForm::stored);

/// For the registry of formats.
FormatCodec webpCodec();

}  // namespace mirrorball
