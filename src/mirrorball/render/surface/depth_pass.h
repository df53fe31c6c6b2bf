#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/render/surface/scene_buffers.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Draws depths before light, so that what is hidden need not be lit: where light costs more than triangles.
class DepthPass {
 public:
  /// errors   unsupported (the driver does not compile a shader)
  static Result<DepthPass> make(gl::Api api);

  /// To be drawn farther away, so that what has the same place is in front of it, or nearer.
  enum class Offset { farther, nearer };

  /// Depths are tested by GL_LEQUAL; culling is as it was.
  void draw(const Scene& scene, int instance, const SceneBuffers& buffers, const Camera& camera, Offset offset);

 private:
  explicit DepthPass(gl::Program program) : program_(std::move(program)) {}

  gl::Program program_;
};

}  // namespace mirrorball
