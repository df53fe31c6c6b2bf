#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace mirrorball {

/// The XMP that a PNG holds compressed or as digits: `XML:com.adobe.xmp` in iTXt or zTXt, and ImageMagick's
/// `Raw profile type xmp` and `Raw profile type APP1` in zTXt or tEXt.
///
/// bytes    of a PNG, or of its beginning
/// returns  the first of these texts with a packet in it; empty where there is none, where it is damaged, or where the
///          texts before it take all that is unpacked (kLongestCompressedXmp)
/// from     PNG, third edition, 11.3.3; ImageMagick, coders/png.c (Magick_png_write_raw_profile)
std::string compressedXmpInPng(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
