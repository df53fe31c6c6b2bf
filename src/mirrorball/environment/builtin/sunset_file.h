#pragma once

#include <cstdint>
#include <span>

namespace mirrorball {

/// The bytes of sunset.exr: 1024 × 512 texels of half floats. A photograph by Greg Zaal (HDRI Haven, CC0), as Blender
/// has it.
std::span<const std::uint8_t> sunsetFile();

}  // namespace mirrorball
