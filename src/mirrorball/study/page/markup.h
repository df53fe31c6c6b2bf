#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// A text as it stands in HTML and SVG, in attributes too: & < > " are written as entities.
std::string escaped(std::string_view text);

/// Bytes as base64 (RFC 4648, section 4).
std::string base64Of(std::span<const std::uint8_t> bytes);

/// A picture as an address that holds all of it: "data:image/png;base64,…".
///
/// errors   as encodePicture's, of a PNG
Result<std::string> dataAddressOf(const Image8& picture);

}  // namespace mirrorball
