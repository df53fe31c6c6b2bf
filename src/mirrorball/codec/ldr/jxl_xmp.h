#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace mirrorball {

/// The XMP that a JPEG XL holds in a box `brob`: an `xml ` box that Brotli has compressed. libjxl unpacks it.
///
/// bytes    of a JPEG XL, or of its beginning
/// returns  of the first such box that has a packet in it; empty where there is none, where it is damaged or behind
///          more than kLongestCompressedXmp of others, or where libjxl lacks Brotli
/// from     ISO/IEC 18181-2:2021, "Brotli-compressed box"
std::string compressedXmpInJxl(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
