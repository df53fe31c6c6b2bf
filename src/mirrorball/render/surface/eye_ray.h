#pragma once

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/gl/program.h"
#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {

/// Sets what shaders/eye_ray.glsl reads.
inline void setEyeRay(gl::Program& program, const Camera& camera) {
  program.set("directions_from_clip", directionsFromClip(camera));
  program.set("camera_position", camera.position);
  program.set("camera_forward", camera.forward);
  program.set("orthographic", camera.orthographic ? 1.0f : 0.0f);
}

/// From texels of a camera's picture and their depths, 0 to 1, to homogeneous places as seen from the camera's, in the
/// world's axes.
///
/// size   of the picture
inline glm::mat4 eyeFromTexels(const Camera& camera, glm::vec2 size) {
  const glm::vec3 whole(size, 1.0f);
  const glm::mat4 clip_from_texels =
      glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(-1.0f)), glm::vec3(2.0f) / whole);
  return directionsFromClip(camera) * clip_from_texels;
}

}  // namespace mirrorball
