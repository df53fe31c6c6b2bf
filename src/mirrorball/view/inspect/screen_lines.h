#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/view/inspect/ray_path.h"

namespace mirrorball {

/// A segment of a path as a picture shows it.
struct ScreenLine {
  glm::vec2 from{0.0f};  ///< pixels from the picture's top left corner, perhaps outside of it
  glm::vec2 to{0.0f};
  std::size_t segment = 0;  ///< of RayPath::segments
};

/// The segments before a camera, cut where they pass its near plane; those behind it are left out. Surfaces do not hide
/// them.
///
/// size   of the picture [pixels]
std::vector<ScreenLine> projected(const RayPath& path, const Camera& camera, glm::ivec2 size);

}  // namespace mirrorball
