#pragma once

#include <filesystem>
#include <optional>

#include <glm/vec2.hpp>

namespace mirrorball {

/// The size of a file's picture as its header states it, before EXIF turns it: of PNG, JPEG, OpenEXR and Radiance HDR.
///
/// returns  nothing where another format holds it, or it cannot be read
/// cost     the ends of the file (readEnds)
std::optional<glm::ivec2> sizeInHeader(const std::filesystem::path& path);

}  // namespace mirrorball
