#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "mirrorball/codec/color/coded_color.h"
#include "mirrorball/codec/color/primaries.h"

namespace mirrorball {

/// What an ICC profile says of a picture's codes, as far as it is understood; as it is made, that there is none.
struct IccProfile {
  std::string description = {};  ///< what it calls itself; "unnamed"; empty: there is no profile
  /// Whether the two below are the profile's, and not sRGB's in place of what is not understood.
  bool is_understood = false;
  TransferCurve curve = kSrgbCurve;
  std::optional<Primaries> primaries = {};  ///< under D65, with white at (1, 1, 1)
};

/// Reads a profile. Of RGB by a matrix and one curve for all channels, sRGB's or a power, its colours are understood:
/// what cameras, phones and programs embed for sRGB, Display P3 and Adobe RGB. Of tables of colours, other curves,
/// other colour spaces and what is damaged it has the name alone.
///
/// cost     some microseconds
/// from     ICC.1:2022, 7.2 and 7.3 (header, tag table), 8.3.3 (matrix profiles), 10.6 (curveType), 10.15
///          (multiLocalizedUnicodeType), 10.18 (parametricCurveType), 10.31 (XYZType); ICC.1:2001-04, 6.5.17
///          (textDescriptionType)
IccProfile readIccProfile(std::span<const std::uint8_t> bytes);

/// What a profile says of codes; without one they are sRGB's.
CodedColor codedColor(const IccProfile& profile);

}  // namespace mirrorball
