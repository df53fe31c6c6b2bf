#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Decodes a surface from a stereolithography file, binary or ascii, told apart by the size (many binary ones begin
/// with "solid" too).
///
/// returns  flat facets: the format holds no more. Facets without area are left out; the stored normals, which many
///          programs leave 0, are not read: the corners' order tells the outside
/// errors   bad_file (the line or byte is named; NaN too)
Result<Scene> decodeStl(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
