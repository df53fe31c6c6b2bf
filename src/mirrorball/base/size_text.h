#pragma once

#include <string>

#include <glm/vec2.hpp>

namespace mirrorball {

/// "512x256": the size of a picture.
inline std::string sizeText(glm::ivec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y); }

}  // namespace mirrorball
