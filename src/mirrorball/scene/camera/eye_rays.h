#pragma once

#include <glm/glm.hpp>

#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {

/// What a place of a picture shows lies on this ray.
struct EyeRay {
  glm::vec3 origin{0.0f};     ///< world
  glm::vec3 direction{0.0f};  ///< world, unit
  float nearest = 0.0f;       ///< distance from which on surfaces are seen: Camera::nearest
};

/// The rays of a camera's picture.
class EyeRays {
 public:
  /// size   of the picture [pixels]
  EyeRays(const Camera& camera, glm::ivec2 size);

  /// pixel   from the picture's top left corner
  EyeRay through(glm::vec2 pixel) const;

 private:
  glm::vec2 size_;
  Camera camera_;
  glm::mat4 places_{1.0f};  // world from clip, of parallel rays
  // Of the far plane, as if the camera stood at the origin; its points follow each other evenly.
  glm::vec3 middle_{0.0f};
  glm::vec3 right_{0.0f};
  glm::vec3 up_{0.0f};
};

}  // namespace mirrorball
