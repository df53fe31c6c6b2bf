#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace mirrorball {

/// What an ICC profile calls itself: "sRGB IEC61966-2.1", "Display P3". Characters beyond ASCII become '?'.
///
/// returns  "unnamed" where it does not say, or is damaged
/// from     ICC.1:2022, 7.2 to 7.3 (header, tag table) and 10.15 (multiLocalizedUnicodeType); ICC.1:2001-04, 6.5.17
///          (textDescriptionType)
std::string iccDescription(std::span<const std::uint8_t> profile);

/// What `info` says of a picture with that profile: profiles are not applied, and sRGB's need not be.
std::string describeIccColor(const std::string& description);

}  // namespace mirrorball
