#pragma once

#include <glm/vec3.hpp>

namespace mirrorball {

// Colours for numbers, sRGB-encoded, in [0, 1]. Their lightness is that of Oklab (Ottosson 2020), in which equal steps
// look equal, so that the ramps can be read without seeing colours, too.

/// From nearly black by violet and orange to light yellow: lightness grows evenly with `t` in [0, 1]. NaN is as 0.
glm::vec3 sequentialColor(float t);

/// From blue by nearly white to red: lightness falls evenly with the distance of `t` in [−1, 1] from 0, alike on both
/// sides. NaN is as 0.
glm::vec3 divergingColor(float t);

}  // namespace mirrorball
