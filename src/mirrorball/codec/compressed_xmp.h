#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace mirrorball {

/// The most bytes of a compressed packet that are unpacked: more than any real one has.
inline constexpr std::size_t kLongestCompressedXmp = std::size_t{1} << 20;

/// The XMP that a file holds compressed or written as digits, where a search of its bytes does not find it: in a PNG's
/// iTXt, zTXt and ImageMagick's "Raw profile type", and in a JPEG XL's `brob` boxes.
///
/// bytes    of a file, or of its beginning
/// returns  text with the packet in it; empty where there is none, where it is damaged, and of all other formats
/// cost     a pass over the file's chunks; at most kLongestCompressedXmp of memory
std::string compressedXmp(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
