#pragma once

#include <string>

#include <glm/glm.hpp>

namespace mirrorball {

/// A camera that a model's file has.
struct ModelCamera {
  std::string name;                 ///< of its scene's cameras no two have the same
  glm::mat4 world_from_view{1.0f};  ///< a rotation and a place; it looks along −Z, +Y is up
  bool orthographic = false;
  float fov_rad = 0.6f;  ///< vertical, in (0, π); of perspective
  float height = 2.0f;   ///< of what a parallel projection shows, in world units; > 0
  float aspect = 0.0f;   ///< width over height of what it is made for; 0: of any picture
  float nearest = 0.0f;  ///< depth from which it sees, in world units

  bool operator==(const ModelCamera&) const = default;
};

}  // namespace mirrorball
