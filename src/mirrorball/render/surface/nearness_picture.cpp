#include "mirrorball/render/surface/nearness_picture.h"

#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/surface/eye_ray.h"
#include "mirrorball/render/surface/surface_variant.h"

namespace mirrorball {

Result<gl::ShaderSource> nearnessShader(gl::Api api, ProxyKind kind) {
  return withProxy(api, "nearness_of_proxy.frag", kind);
}

Result<NearnessPicture> NearnessPicture::make(gl::Api api) {
  MIRRORBALL_TRY(program, gl::Program::load(api, "back_faces.vert", "nearness.frag"));
  return NearnessPicture(std::move(program));
}

Result<void> NearnessPicture::draw(const Scene& scene, const SceneBuffers& buffers, const FrameUniforms& frame,
                                   float unit, glm::ivec2 size) {
  MIRRORBALL_TRY_VOID(gl::resize(framebuffer_, gl::Format::rgba32f, size, true));
  framebuffer_->bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  const Camera& camera = frame.camera;
  program_.set("clip_from_world", camera.clip_from_view * camera.view_from_world);
  program_.set("camera_position", camera.position);
  program_.set("unit", unit);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Material& material = materialOf(scene, i);
    if (material.alpha_mode == AlphaMode::blend || isAmong(frame.hidden, i)) continue;
    if (material.double_sided)
      glDisable(GL_CULL_FACE);
    else
      glEnable(GL_CULL_FACE);
    program_.set("world_from_object", scene.instances[i].world_from_object);
    buffers.drawMesh(scene.instances[i].mesh);
  }
  return {};
}

/// Where nothing else is.
Result<void> NearnessPicture::drawProxy(gl::Api api, const FrameUniforms& frame, float unit) {
  const ProxyKind kind = frame.proxy->proxy().kind;
  if (kind == ProxyKind::none) return {};
  auto found = of_proxy_.find(kind);
  if (found == of_proxy_.end()) {
    MIRRORBALL_TRY(vertex, gl::shaderSource(api, "screen.vert"));
    MIRRORBALL_TRY(fragment, nearnessShader(api, kind));
    MIRRORBALL_TRY(program, gl::Program::build(vertex, fragment, "screen.vert with nearness_of_proxy.frag"));
    frame.proxy->connect(program, kind);
    found = of_proxy_.emplace(kind, std::move(program)).first;
  }
  gl::Program& program = found->second;
  setEyeRay(program, frame.camera);
  program.set("unit", unit);
  frame.proxy->bind();
  glDisable(GL_CULL_FACE);
  program.use();
  screen_.draw(3);
  return {};
}

}  // namespace mirrorball
