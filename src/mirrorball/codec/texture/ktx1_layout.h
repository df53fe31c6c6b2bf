#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace mirrorball::ktx1 {

/// «KTX 11», then what reveals a file that was sent as text.
inline constexpr std::array<std::uint8_t, 12> kIdentifier = {0xab, 'K',  'T',  'X',  ' ',  '1',
                                                             '1',  0xbb, '\r', '\n', 0x1a, '\n'};
inline constexpr std::uint32_t kByteOrder = 0x04030201;  ///< as a number: the bytes tell the order of all others
inline constexpr std::size_t kKtx1HeaderSize = 64;
inline constexpr std::size_t kAlignment = 4;  ///< of rows, faces and levels

// glType.
inline constexpr std::uint32_t kUnsignedByte = 0x1401;
inline constexpr std::uint32_t kUnsignedShort = 0x1403;
inline constexpr std::uint32_t kFloat = 0x1406;
inline constexpr std::uint32_t kHalfFloat = 0x140b;
inline constexpr std::uint32_t kHalfFloatOes = 0x8d61;
inline constexpr std::uint32_t kUnsignedInt10F11F11FRev = 0x8c3b;
inline constexpr std::uint32_t kUnsignedInt5999Rev = 0x8c3e;

// glFormat.
inline constexpr std::uint32_t kRgb = 0x1907;
inline constexpr std::uint32_t kRgba = 0x1908;
inline constexpr std::uint32_t kRg = 0x8227;

// glInternalFormat.
inline constexpr std::uint32_t kRgba32F = 0x8814;
inline constexpr std::uint32_t kRgba16F = 0x881a;
inline constexpr std::uint32_t kRg16F = 0x822f;
inline constexpr std::uint32_t kRg32F = 0x8230;
/// Filament's cmgen has it as glType too, where the specification says kUnsignedInt10F11F11FRev.
inline constexpr std::uint32_t kR11FG11FB10F = 0x8c3a;
inline constexpr std::uint32_t kRgb9E5 = 0x8c3d;
inline constexpr std::uint32_t kRgbBptcSignedFloat = 0x8e8e;
inline constexpr std::uint32_t kRgbBptcUnsignedFloat = 0x8e8f;

}  // namespace mirrorball::ktx1
