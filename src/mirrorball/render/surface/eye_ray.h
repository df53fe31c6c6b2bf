#pragma once

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

}  // namespace mirrorball
