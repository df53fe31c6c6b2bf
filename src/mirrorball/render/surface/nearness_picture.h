#pragma once

#include <map>
#include <optional>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/render/surface/frame_uniforms.h"
#include "mirrorball/scene/proxy/proxy.h"

namespace mirrorball {

/// shaders/nearness_of_proxy.frag, for an environment whose light comes from there.
///
/// errors   not_found: a part's file (a mistake in the table of parts)
Result<gl::ShaderSource> nearnessShader(gl::Api api, ProxyKind kind);

/// A picture of how near all is that a camera sees: 1 / distance from the camera's place, as
/// formula/proxy/captured_sight.glsl reads it. What is cut away is not there; surfaces that are blended are left out.
class NearnessPicture {
 public:
  /// errors   unsupported (the driver does not compile a shader)
  static Result<NearnessPicture> make(gl::Api api);

  /// Draws it: what a picture of the frame shows, by its depths, before the environment's proxy. The framebuffer is
  /// another one then; blending is off.
  ///
  /// picture  with depths
  /// unit     of length, in world units
  /// errors   too_large; unsupported
  Result<void> draw(gl::Api api, const gl::Framebuffer& picture, const FrameUniforms& frame, float unit);

  const gl::Texture& picture() const { return framebuffer_->color(); }

 private:
  explicit NearnessPicture(gl::Program program) : program_(std::move(program)) {}
  Result<void> drawProxy(gl::Api api, const FrameUniforms& frame, float unit);

  gl::Program program_;
  std::map<ProxyKind, gl::Program> of_proxy_;
  std::optional<gl::Framebuffer> framebuffer_;
  gl::VertexArray screen_;
};

}  // namespace mirrorball
