#pragma once

#include <map>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/light/proxy_uniforms.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/surface/frame_uniforms.h"

namespace mirrorball {

/// What is behind everything where the environment is not shown: radiance and 1, or nothing.
glm::vec4 pageOf(const FrameSettings& settings);

/// shaders/background.frag, for an environment whose light comes from there.
///
/// errors   not_found: a part's file (a mistake in the table of parts)
Result<gl::ShaderSource> backgroundShader(gl::Api api, ProxyKind kind);

/// The environment behind everything (shaders/background.frag).
class Background {
 public:
  /// Makes what a proxy of that kind is drawn by.
  ///
  /// errors   unsupported (the driver does not compile it)
  Result<void> make(gl::Api api, ProxyUniforms& proxy);

  /// Draws it, sharp or blurred as the settings say, where nothing else has been drawn yet; where they show no
  /// environment, the shadow on the ground alone.
  void draw(const EnvironmentLight& light, const FrameUniforms& frame, const FrameSettings& settings);

 private:
  std::map<ProxyKind, gl::Program> programs_;
  gl::VertexArray screen_;
};

}  // namespace mirrorball
