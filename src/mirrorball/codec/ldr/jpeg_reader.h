#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/ldr/coded_file.h"

namespace mirrorball {

/// A JPEG's picture by itself, whatever lies behind it.
struct JpegPicture {
  CodedFile file;                ///< 1 or 3 channels, or 4; with what is odd about it
  std::size_t missing_rows = 0;  ///< that are black, since the file lacks them
};

/// Decodes a JPEG as far as it goes.
///
/// errors   as decodeJpegCodes'
Result<JpegPicture> readJpegPicture(std::span<const std::uint8_t> bytes, CodeForm form);

}  // namespace mirrorball
