#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Decodes a surface from a stereolithography file, binary or in words, distinguished by the size (many binary ones
/// begin with "solid" too), then by whether it is text.
///
/// path     for warnings, which begin with it
/// returns  flat facets, with their colours where a binary file has some (stl_facets.h). Facets without area are left
///          out; the stored normals, which many programs leave 0, are not read: the corners' order tells the outside.
///          What is left out besides is a warning in the scene
/// errors   bad_file (no facet is left); too_large
Result<Scene> decodeStl(std::span<const std::uint8_t> bytes, const std::filesystem::path& path);

}  // namespace mirrorball
