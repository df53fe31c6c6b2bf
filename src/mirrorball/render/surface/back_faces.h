#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/render/surface/scene_buffers.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A picture of the back faces of a scene's bodies (isBody), of each pixel the nearest: from outside of closed bodies
/// that is where a straight ray leaves the first one. What its texels hold, formula/bodies/back_face.glsl says.
///
/// It shows an eighth of the frame's longer side more on each side, for light that leaves beside the frame.
class BackFaces {
 public:
  /// errors   unsupported (the driver does not compile a shader)
  static Result<BackFaces> make(gl::Api api);

  /// Makes the picture for a frame of that size, unless there is one. It must be called before `picture`.
  ///
  /// errors   too_large
  Result<void> resize(glm::ivec2 size);

  /// Draws them as a camera sees them in a frame of that size. The framebuffer is another one then; blending is off.
  ///
  /// hidden   instances that are not drawn
  /// errors   too_large
  /// cost     as a frame of these bodies without light; 16 bytes a texel
  Result<void> draw(const Scene& scene, const SceneBuffers& buffers, const Camera& camera, glm::ivec2 size,
                    std::span<const int> hidden = {});

  const gl::Texture& picture() const { return framebuffer_->color(); }

  /// From homogeneous places of the world to (x, y) of texels, with clip space's depth.
  const glm::mat4& texelsFromWorld() const { return texels_from_world_; }
  /// And back, to places relative to the camera's, in the world's axes.
  const glm::mat4& eyeFromTexels() const { return eye_from_texels_; }

 private:
  explicit BackFaces(gl::Program program) : program_(std::move(program)) {}

  gl::Program program_;
  std::optional<gl::Framebuffer> framebuffer_;
  glm::mat4 texels_from_world_{1.0f};
  glm::mat4 eye_from_texels_{1.0f};
};

}  // namespace mirrorball
