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

/// A picture of what rays meet of a scene's relief where it is found exactly: of each pixel the nearest prism, and the
/// place in it (shaders/relief_hits.frag). Each prism is drawn as a box, and most pixels of boxes miss what is in them;
/// so that only what is seen is shaded, and neighbouring pixels can be compared, light comes in a second pass.
class ReliefHits {
 public:
  /// errors   unsupported (the driver does not compile a shader)
  static Result<ReliefHits> make(gl::Api api);

  /// Makes the picture for a frame of that size, unless there is one. It must be called before `picture`.
  ///
  /// errors   too_large
  Result<void> resize(glm::ivec2 size);

  /// Draws it as a camera sees it in a frame of that size. The framebuffer is another one then; blending is off.
  ///
  /// buffers  with the prisms of all meshes whose material has heights
  /// hidden   instances that are not drawn
  /// errors   too_large
  Result<void> draw(const Scene& scene, const SceneBuffers& buffers, const Camera& camera, glm::ivec2 size,
                    std::span<const int> hidden = {});

  const gl::Texture& picture() const { return framebuffer_->color(); }

 private:
  explicit ReliefHits(gl::Program program) : program_(std::move(program)) {}
  void drawInstance(const Scene& scene, const SceneBuffers& buffers, std::size_t instance);

  gl::Program program_;
  std::optional<gl::Framebuffer> framebuffer_;
};

}  // namespace mirrorball
