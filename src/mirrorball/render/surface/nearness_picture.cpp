#include "mirrorball/render/surface/nearness_picture.h"

#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/surface/eye_ray.h"
#include "mirrorball/render/surface/surface_shaders.h"
#include "mirrorball/render/surface/texture_units.h"

namespace mirrorball {
Result<gl::ShaderSource> nearnessShader(gl::Api api, ProxyKind kind) {
  return withProxy(api, "nearness_of_proxy.frag", kind);
}

Result<NearnessPicture> NearnessPicture::make(gl::Api api) {
  MIRRORBALL_TRY(program, gl::Program::load(api, "screen.vert", "nearness.frag"));
  program.set("depths", kFreeUnit);
  return NearnessPicture(std::move(program));
}

Result<void> NearnessPicture::draw(gl::Api api, const gl::Framebuffer& picture, const FrameUniforms& frame,
                                   float unit) {
  const glm::ivec2 size(picture.width(), picture.height());
  MIRRORBALL_TRY_VOID(gl::resize(framebuffer_, gl::Format::rgba32f, size));
  framebuffer_->bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  gl::drawOverAll();
  MIRRORBALL_TRY_VOID(drawProxy(api, frame, unit));
  picture.depth().bind(kFreeUnit);
  program_.set("eye_from_texels", eyeFromTexels(frame.sample.camera, size));
  program_.set("unit", unit);
  program_.use();
  screen_.draw(3);
  return {};
}

Result<void> NearnessPicture::drawProxy(gl::Api api, const FrameUniforms& frame, float unit) {
  const ProxyKind kind = frame.light.proxy->proxy().kind;
  if (kind == ProxyKind::none) return {};
  auto found = of_proxy_.find(kind);
  if (found == of_proxy_.end()) {
    MIRRORBALL_TRY(vertex, gl::shaderSource(api, "screen.vert"));
    MIRRORBALL_TRY(fragment, nearnessShader(api, kind));
    MIRRORBALL_TRY(program, gl::Program::build(vertex, fragment, "screen.vert with nearness_of_proxy.frag"));
    frame.light.proxy->connection().connect(program, kind, kNextFreeUnit);
    found = of_proxy_.emplace(kind, std::move(program)).first;
  }
  gl::Program& program = found->second;
  setEyeRay(program, frame.sample.camera);
  program.set("unit", unit);
  frame.light.proxy->bind(kNextFreeUnit);
  program.use();
  screen_.draw(3);
  return {};
}

}  // namespace mirrorball
