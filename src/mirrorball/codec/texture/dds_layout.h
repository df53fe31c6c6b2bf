#pragma once

#include <cstddef>
#include <cstdint>

namespace mirrorball::dds {

/// Microsoft's names from ddraw.h and dds.h, in words.

inline constexpr std::size_t kDdsHeaderSize = 128;  ///< magic and DDS_HEADER
inline constexpr std::size_t kDx10HeaderSize = 20;  ///< DDS_HEADER_DXT10 behind it

/// Four letters as a number.
constexpr std::uint32_t fourLetters(const char (&letters)[5]) {
  std::uint32_t number = 0;
  for (int i = 3; i >= 0; --i) number = number << 8 | static_cast<unsigned char>(letters[i]);
  return number;
}
inline constexpr std::uint32_t kMagic = fourLetters("DDS ");
inline constexpr std::uint32_t kDx10 = fourLetters("DX10");

// DDS_HEADER.dwFlags
inline constexpr std::uint32_t kHasCaps = 0x1;
inline constexpr std::uint32_t kHasHeight = 0x2;
inline constexpr std::uint32_t kHasWidth = 0x4;
inline constexpr std::uint32_t kHasPitch = 0x8;
inline constexpr std::uint32_t kHasPixelFormat = 0x1000;
inline constexpr std::uint32_t kHasMipCount = 0x20000;
inline constexpr std::uint32_t kHasLinearSize = 0x80000;

// DDS_PIXELFORMAT.dwFlags
inline constexpr std::uint32_t kPixelFourLetters = 0x4;
inline constexpr std::uint32_t kPixelRgb = 0x40;
inline constexpr std::uint32_t kPixelLuminance = 0x20000;

// dwCaps and dwCaps2
inline constexpr std::uint32_t kCapsComplex = 0x8;
inline constexpr std::uint32_t kCapsTexture = 0x1000;
inline constexpr std::uint32_t kCapsMips = 0x400000;
inline constexpr std::uint32_t kCaps2Cube = 0x200;
inline constexpr std::uint32_t kCaps2AllFaces = 0xfc00;
inline constexpr std::uint32_t kCaps2Volume = 0x200000;

// DDS_HEADER_DXT10
inline constexpr std::uint32_t kTexture2d = 3;
inline constexpr std::uint32_t kMiscCube = 0x4;
inline constexpr std::uint32_t kAlphaStraight = 1;
inline constexpr std::uint32_t kAlphaOpaque = 3;

}  // namespace mirrorball::dds
