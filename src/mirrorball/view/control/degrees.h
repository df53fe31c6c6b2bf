#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace mirrorball {

/// An angle in [−180, 180).
inline float wrappedAngle(float angle_deg) { return angle_deg - 360.0f * std::floor((angle_deg + 180.0f) / 360.0f); }

/// How far a hand turns something: half a turn for the picture's shorter side.
inline glm::vec2 degreesOf(glm::vec2 by_px, glm::ivec2 size) {
  return by_px * 180.0f / static_cast<float>(std::max(std::min(size.x, size.y), 1));
}

}  // namespace mirrorball
