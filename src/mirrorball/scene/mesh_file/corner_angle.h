#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace mirrorball {

// In double precision: coordinates up to the largest float then neither overflow nor lose small triangles.

/// A unit vector along `direction`, or `otherwise` where that has no length.
inline glm::dvec3 unitOr(glm::dvec3 direction, glm::dvec3 otherwise) {
  const double length = glm::length(direction);
  return length > 0.0 ? direction / length : otherwise;
}

/// The angle of a face at `corner`, between the corners after and before it, in radians; 0 where it is degenerate.
inline double angleAt(glm::dvec3 corner, glm::dvec3 next, glm::dvec3 previous) {
  const glm::dvec3 a = next - corner;
  const glm::dvec3 b = previous - corner;
  // atan2 stays exact near 0 and π, where the arc cosine of a dot product does not.
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace mirrorball
