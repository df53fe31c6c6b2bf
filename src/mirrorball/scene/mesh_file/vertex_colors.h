#pragma once

#include <glm/vec3.hpp>

#include "mirrorball/scene/material/material.h"

namespace mirrorball {

/// The linear colour that codes of sRGB stand for, from 0 to 1; beyond that they are cut, and NaN is white.
glm::vec3 linearFromCodes(glm::vec3 codes);

/// The material of a surface whose file names none. Colours of vertices multiply the base colour, which is white where
/// there are some.
Material materialOfColors(bool has_colors);

}  // namespace mirrorball
