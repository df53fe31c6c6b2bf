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
  formula::Media media = {};  ///< that it is in
};

}  // namespace mirrorball
