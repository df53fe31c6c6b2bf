#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec2.hpp>

namespace mirrorball {

/// The size of a PNG's or a JPEG's picture as its header states it, before EXIF turns it.
///
/// bytes    the begin of a file, up to its header's end at least
/// returns  nothing for other formats, and where no image may have that size (checkDimensions)
/// from     PNG, third edition, 11.2.1 (IHDR); ITU-T T.81, B.2.2 (the frame header)
std::optional<glm::ivec2> sizeInHeader(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
