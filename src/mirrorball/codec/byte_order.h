#pragma once

#include <cstdint>

namespace mirrorball {

/// Numbers from bytes, whatever the machine's own byte order and the place's alignment.

inline std::uint16_t littleU16(const std::uint8_t* bytes) {
  return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
}

inline std::uint32_t littleU32(const std::uint8_t* bytes) {
  return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
}

inline std::uint64_t littleU64(const std::uint8_t* bytes) {
  return littleU32(bytes) | std::uint64_t{littleU32(bytes + 4)} << 32;
}

inline std::uint16_t bigU16(const std::uint8_t* bytes) { return static_cast<std::uint16_t>(bytes[1] | bytes[0] << 8); }

inline std::uint32_t bigU32(const std::uint8_t* bytes) {
  return bytes[3] | std::uint32_t{bytes[2]} << 8 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[0]} << 24;
}

}  // namespace mirrorball
