#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace mirrorball {

/// Whether a text is the six digits of a colour without their '#': "336699", which is a number too.
bool isHexCode(std::string_view text);

/// "#rrggbb", sRGB's codes, as linear light; nothing: it is another text.
std::optional<glm::vec3> parseHexColor(std::string_view text);

/// Linear light as "#rrggbb"; what lies outside [0, 1] is clamped.
std::string hexColor(glm::vec3 linear);

}  // namespace mirrorball
