#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Loads a surface from a stereolithography file, binary or ascii, told apart by the size (many binary ones begin with
/// "solid" too).
///
/// returns  flat facets: the format holds no more. Facets without area are left out; the stored normals, which many
///          programs leave 0, are not read: the corners' order tells the outside
/// errors   not_found; io; bad_file (the line or byte is named; NaN too)
Result<Scene> loadStl(const std::filesystem::path& path);

/// The same from memory. `name` is for messages.
Result<Scene> decodeStl(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace mirrorball
