#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace mirrorball {

inline bool isFinite(glm::vec3 p) { return !glm::any(glm::isnan(p)) && !glm::any(glm::isinf(p)); }

/// A box along the axes. As it begins, it holds nothing.
struct Box {
  glm::vec3 low{INFINITY};
  glm::vec3 high{-INFINITY};

  void include(const Box& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  bool isEmpty() const { return !(low.x <= high.x); }
  glm::vec3 center() const { return (low + high) / 2.0f; }
  /// Half its area; 0 if it holds nothing.
  float halfArea() const {
    const glm::vec3 side = glm::max(high - low, glm::vec3(0.0f));
    return side.x * side.y + side.y * side.z + side.z * side.x;
  }
};

/// A box in double precision, for places whose numbers floats do not hold.
struct DoubleBox {
  glm::dvec3 low{INFINITY};
  glm::dvec3 high{-INFINITY};

  void include(glm::dvec3 place) {
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  bool isEmpty() const { return !(low.x <= high.x); }
  glm::dvec3 center() const { return 0.5 * (low + high); }
  Box rounded() const { return {glm::vec3(low), glm::vec3(high)}; }
};

}  // namespace mirrorball
