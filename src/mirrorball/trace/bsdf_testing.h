#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include "formula/constants.h"

namespace mirrorball::testing {

/// In the plane of X and Z, at an angle to +Z.
inline glm::vec3 directionOf(float cosine) { return {std::sqrt(1.0f - cosine * cosine), 0.0f, cosine}; }

/// A direction of equal density over the whole sphere.
inline glm::vec3 onSphere(glm::vec2 u) {
  const float z = 1.0f - 2.0f * u.x, radius = std::sqrt(std::max(1.0f - z * z, 0.0f));
  return {radius * std::cos(formula::kTwoPi * u.y), radius * std::sin(formula::kTwoPi * u.y), z};
}

/// A mean and its standard error.
struct Estimate {
  double sum = 0.0, squares = 0.0;
  int count = 0;

  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double mean() const { return sum / count; }
  double error() const { return std::sqrt(std::max(squares / count - mean() * mean(), 0.0) / count); }
};

}  // namespace mirrorball::testing
