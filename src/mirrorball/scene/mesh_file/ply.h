#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Decodes a surface from a Polygon File Format (Stanford) file: ascii or binary of either byte order, properties of
/// any type and order, faces with any number of corners, triangle strips.
///
/// returns  normals, texture coordinates (v turned to grow downwards) and colours (integers as sRGB, floats as linear)
///          where the file has them. Normals where it has none: edges are smooth under 45°, as in OBJ
/// errors   bad_file (the line or byte is named; NaN and indices out of range too); unsupported (points
///          without faces)
Result<Scene> decodePly(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
