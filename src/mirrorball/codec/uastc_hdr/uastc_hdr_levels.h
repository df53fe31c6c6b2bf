#pragma once

#include <array>
#include <cstdint>

namespace mirrorball {

/// The weights that texels can have, ascending.
struct WeightLevels {
  int count = 0;
  std::array<std::uint8_t, 16> shares{};   ///< of the second end in 64ths
  std::array<std::uint8_t, 16> numbers{};  ///< by which a block stores them
};

/// The numbers from 0 to 255 that the ends' colours can have.
struct EndpointLevels {
  std::array<std::uint8_t, 256> values{};   ///< of the numbers by which a block stores them
  std::array<std::uint8_t, 256> numbers{};  ///< the inverse, of these values only
  std::array<std::uint8_t, 256> nearest{};  ///< of each byte: the nearest value whose upper three bits are the same
};

/// The levels of a UastcHdrMode.
///
/// count    one that kUastcHdrModes has
/// from     Khronos Data Format Specification 1.3, ASTC: "Weight Unquantization", "Endpoint Unquantization"
const WeightLevels& weightLevels(int count);
const EndpointLevels& endpointLevels(int count);

}  // namespace mirrorball
