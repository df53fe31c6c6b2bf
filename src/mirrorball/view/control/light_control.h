#pragma once

#include <glm/glm.hpp>

namespace mirrorball {

/// FrameSettings::env_rotation_deg after a hand has turned the light: about the upright axis, half a turn for the
/// picture's shorter side. Highlights of what lies before the camera move with the hand, the background behind it goes
/// the other way.
///
/// by_px   how far the hand has moved; up and down does nothing, so that the horizon stays level
/// returns the angle about the upright axis in [−180, 180), the others as they were
glm::vec3 turnedLight(glm::vec3 env_rotation_deg, glm::vec2 by_px, glm::ivec2 size);

}  // namespace mirrorball
