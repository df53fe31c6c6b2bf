#pragma once

#include <cmath>
#include <limits>

#include <glm/glm.hpp>

namespace mirrorball {

/// Whether a vector's square is a float with all of its bits: that of an edge of a model of the size of 1e-9 or 1e12,
/// multiplied by another, is none.
inline bool hasPlainSquare(glm::vec3 v) {
  const float squared = glm::dot(v, v);
  return squared >= std::numeric_limits<float>::min() && squared <= std::numeric_limits<float>::max();
}

/// The direction of a vector of any length.
///
/// otherwise   of what has none: 0, or no numbers
inline glm::vec3 directionOr(glm::vec3 v, glm::vec3 otherwise) {
  if (hasPlainSquare(v)) return glm::normalize(v);
  const double length = glm::length(glm::dvec3(v));
  return length > 0.0 && std::isfinite(length) ? glm::vec3(glm::dvec3(v) / length) : otherwise;
}

}  // namespace mirrorball
