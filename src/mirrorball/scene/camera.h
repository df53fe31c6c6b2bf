#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Where a camera stands and what it sees, as a user says it.
struct CameraOptions {
  float azimuth_deg = 30.0f;             ///< 0 stands on +Z and looks along −Z, 90 stands on +X
  float elevation_deg = 15.0f;           ///< 90 stands on +Y
  std::optional<float> distance = {};    ///< from the target, in model radii; without it the model fills the picture
  std::optional<glm::vec3> target = {};  ///< world; without it the model's centre
  float fov_deg = 35.0f;                 ///< vertical angle of view
  std::optional<float> orthographic_height = {};  ///< of the view, in model radii; turns perspective off
};

/// A camera as the renderer needs it: right-handed view space, looking along −Z, +Y up.
struct Camera {
  glm::mat4 view_from_world{1.0f};
  glm::mat4 clip_from_view{1.0f};
  glm::vec3 position{0.0f};              ///< world
  glm::vec3 forward{0.0f, 0.0f, -1.0f};  ///< world, unit
  bool orthographic = false;
};

/// Puts a camera before a model.
///
/// bounds   the model's bounding sphere
/// aspect   width over height of the picture
Camera makeCamera(const CameraOptions& options, const BoundingSphere& bounds, float aspect);

}  // namespace mirrorball
