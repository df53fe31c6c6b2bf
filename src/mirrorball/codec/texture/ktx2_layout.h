#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace mirrorball {

/// «KTX 20», then what reveals a file that was sent as text.
inline constexpr std::array<std::uint8_t, 12> kKtx2Identifier = {0xab, 'K',  'T',  'X',  ' ',  '2',
                                                                 '0',  0xbb, '\r', '\n', 0x1a, '\n'};

inline constexpr std::size_t kKtx2HeaderSize = 80;  ///< up to the level index
inline constexpr std::size_t kKtx2LevelSize = 24;   ///< of one entry of the level index: offset, size, size unpacked

// Supercompression schemes.
inline constexpr std::uint32_t kKtx2Plain = 0;
inline constexpr std::uint32_t kKtx2Zstandard = 2;

}  // namespace mirrorball
