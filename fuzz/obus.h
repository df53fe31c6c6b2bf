#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "mirrorball/base/file.h"

namespace mirrorball::fuzz {

/// An open bitstream unit, of which AV1 data consists (AV1 Bitstream & Decoding Process Specification 1.0.0, 5.3).
struct Obu {
  Bytes header;  ///< one byte or two
  Bytes payload;

  unsigned type() const { return header.front() >> 3 & 15u; }
};

/// Nothing where a unit is longer than the data.
std::optional<std::vector<Obu>> obusIn(std::span<const std::uint8_t> data);

/// The units with their right sizes.
Bytes bytesOfObus(const std::vector<Obu>& obus);

/// Changes AV1 data, most of the time the coded texels, else a header or what units there are. Data that does not
/// consist of units is changed anywhere.
void changeAv1(Bytes& data, std::mt19937& random);

}  // namespace mirrorball::fuzz
