#pragma once

#include <glm/glm.hpp>

#include "formula/tangent.h"

namespace mirrorball {

/// The frame of a surface: +Z is its normal, +X its tangent.
struct Frame {
  explicit Frame(glm::vec3 normal) : Frame(normal, formula::anyTangent(normal)) {}
  /// Both unit and orthogonal.
  Frame(glm::vec3 normal, glm::vec3 tangent) : n(normal), t(tangent), b(glm::cross(normal, tangent)) {}

  glm::vec3 toLocal(glm::vec3 w) const { return {glm::dot(w, t), glm::dot(w, b), glm::dot(w, n)}; }
  glm::vec3 toWorld(glm::vec3 w) const { return w.x * t + w.y * b + w.z * n; }

  glm::vec3 n, t, b;
};

}  // namespace mirrorball
