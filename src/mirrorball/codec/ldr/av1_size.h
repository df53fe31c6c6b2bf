#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec2.hpp>

namespace mirrorball {

/// The largest size that AV1 data says its pictures have, which a decoder takes memory for. What is around the data, as
/// in an AVIF, may say another one.
///
/// obus     open bitstream units, one behind the other
/// returns  of all sequence headers the largest width and the largest height, up to the first unit that is cut; nothing
///          where there is none
/// from     AV1 Bitstream & Decoding Process Specification 1.0.0 with errata 1, 5.3 to 5.5
std::optional<glm::uvec2> sizeInAv1(std::span<const std::uint8_t> obus);

}  // namespace mirrorball
