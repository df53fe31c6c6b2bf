#pragma once

#include <map>
#include <optional>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/render/surface/scene_buffers.h"
#include "mirrorball/render/surface/surface_program.h"
#include "mirrorball/scene/proxy/proxy.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// shaders/nearness_of_proxy.frag, for an environment whose light comes from there.
///
/// errors   not_found: a part's file (a mistake in the table of parts)
Result<gl::ShaderSource> nearnessShader(gl::Api api, ProxyKind kind);

/// A picture of how near all is that a camera sees: 1 / distance from the camera's place, as
/// formula/proxy/captured_sight.glsl reads it. Surfaces that are blended are left out, and relief does not move places.
class NearnessPicture {
 public:
  /// errors   unsupported (the driver does not compile a shader)
  static Result<NearnessPicture> make(gl::Api api);

  /// Draws it. The framebuffer is another one then; blending is off.
  ///
  /// unit     of length, in world units
  /// size     of the picture
  /// errors   too_large
  /// cost     as a frame without light
  Result<void> draw(const Scene& scene, const SceneBuffers& buffers, const FrameUniforms& frame, float unit,
                    glm::ivec2 size);

  /// Draws the proxy, behind what has been drawn.
  ///
  /// errors   unsupported
  Result<void> drawProxy(gl::Api api, const FrameUniforms& frame, float unit);

  const gl::Texture& picture() const { return framebuffer_->color(); }

 private:
  explicit NearnessPicture(gl::Program program) : program_(std::move(program)) {}

  gl::Program program_;
  std::map<ProxyKind, gl::Program> of_proxy_;
  std::optional<gl::Framebuffer> framebuffer_;
  gl::VertexArray screen_;
};

}  // namespace mirrorball
