#pragma once

#include <optional>
#include <string_view>

namespace mirrorball {

/// The text of a file of shaders/ or formula/ ("surface.frag", "optics.glsl") as it was when the
/// library was built, so that an installed program needs no files beside it.
std::optional<std::string_view> embeddedText(std::string_view name);

}  // namespace mirrorball
