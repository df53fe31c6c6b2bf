#pragma once

#include <glm/vec3.hpp>

namespace mirrorball {

/// The radiance of the built-in environment "uv": six faces of their own colours, each with its name, a grid and a
/// small triangle that points up; names read normally when one looks along +Z with +Y up (+X is on the left) and turns
/// the head. In OpenGL's left-handed cube faces they are mirrored.
glm::vec3 uvRadiance(glm::vec3 direction);

}  // namespace mirrorball
