#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/texture/stored_format.h"

namespace mirrorball {

/// The colour model of UASTC HDR 4x4: Basis Universal's, to tell it from other ASTC (162).
inline constexpr std::uint8_t kModelUastcHdr = 167;

/// What a descriptor says about colour.
struct DescribedColor {
  int model = 1;  ///< 1: red, green, blue, alpha; 163, 166 and 167 are Basis Universal's
  bool srgb = false;
  bool has_other_curve = false;        ///< neither linear nor sRGB's
  std::optional<Primaries> primaries;  ///< nothing where they are Rec.709's or unspecified
  bool is_missing = false;             ///< the file has none, or an empty one
};

/// Reads a Khronos data format descriptor, as far as the texels' format does not tell it already.
///
/// bytes    the whole file
/// begin    where the descriptor begins, and `size` its bytes: both within the file
/// as       of numbers no transfer function counts
/// errors   bad_file (the byte is named); unsupported (a transfer function other than linear and sRGB)
/// from     Khronos Data Format Specification 1.4, "The Khronos Basic Data Format Descriptor Block"
Result<DescribedColor> readDataFormatDescriptor(std::span<const std::uint8_t> bytes, std::size_t begin,
                                                std::size_t size, ReadAs as = ReadAs::light);

/// The descriptor of one of the formats that are written: linear light, straight alpha.
Bytes dataFormatDescriptor(TexelFormat format, OutputPrimaries primaries = OutputPrimaries::rec709);

}  // namespace mirrorball
