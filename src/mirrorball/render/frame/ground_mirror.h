#pragma once

#include <optional>
#include <utility>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/surface/frame_uniforms.h"
#include "mirrorball/scene/box.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The mirror image of the scene in a polished ground: a picture from below (planar reflection), in which the rays of
/// rough mirrors are followed (formula/proxy/glossy_ground.glsl).
class GroundMirror {
 public:
  /// proxy    connected to what is made
  /// errors   unsupported (the driver does not compile a shader)
  static Result<GroundMirror> make(gl::Api api, ProxyUniforms& proxy);

  /// What the picture from below is to be drawn into, with the camera `below()` and nothing behind the scene.
  ///
  /// sample   by whose camera it is drawn, and whether that tests a stencil
  /// bounds   of the scene
  /// size     pixels; a blurred image needs fewer than the frame has
  /// errors   too_large; no_gl
  Result<const gl::Framebuffer*> begin(const SampleUniforms& sample, float ground, const BoundingSphere& bounds,
                                       glm::ivec2 size);
  const Camera& below() const { return below_; }
  /// Makes what is read of that picture, with mip levels if it is to be blurred.
  ///
  /// errors   too_large
  Result<void> finish(bool is_blurred);

  /// Lays the mirror image over the ground where nothing is drawn before it.
  ///
  /// frame    of the sample; its proxy is bound
  /// scene    the box around it
  void draw(const FrameUniforms& frame, const FrameSettings& settings, const Box& scene);

 private:
  GroundMirror(gl::Program program, gl::Program to_halves)
      : program_(std::move(program)), to_halves_(std::move(to_halves)) {}

  gl::Program program_;
  gl::Program to_halves_;
  gl::VertexArray screen_;
  std::optional<gl::Framebuffer> picture_;  ///< of floats, with depths
  std::optional<gl::Framebuffer> halves_;   ///< the same light, filtered
  Camera below_;
};

}  // namespace mirrorball
