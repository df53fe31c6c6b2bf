#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "formula/bodies.h"
#include "mirrorball/rays/geometry.h"

namespace mirrorball {

/// A straight piece of a path.
struct Ray {
  glm::vec3 origin{0.0f};
  glm::vec3 direction{0.0f};  ///< unit
  float nearest = 0.0f;       ///< distance from which on surfaces are there
  /// The triangle that it leaves, which a plane cannot meet again; a relief can be met again.
  std::optional<Hit> from = {};
  /// Whether it passes the backs of surfaces that have only a front: as the renderer's eye does, also through sheets of
  /// glass, and as light must that a smooth normal sends below its flat triangle.
  bool passes_backs = true;
  formula::Media media = {};  ///< that it is in
};

}  // namespace mirrorball
