#include "mirrorball/render/surface/relief_hits.h"

#include <cmath>
#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/surface/height_map_uniform.h"
#include "mirrorball/render/surface/texture_units.h"

namespace mirrorball {
Result<ReliefHits> ReliefHits::make(gl::Api api) {
  MIRRORBALL_TRY(program, gl::Program::load(api, "relief_hits.vert", "relief_hits.frag"));
  program.set("heights", kFreeUnit);
  program.set("prisms", kNextFreeUnit);
  return ReliefHits(std::move(program));
}

Result<void> ReliefHits::resize(glm::ivec2 size) {
  return gl::resize(framebuffer_, gl::Format::rgba32f, size, gl::Depths::alone);
}

Result<void> ReliefHits::draw(const Scene& scene, const SceneBuffers& buffers, const Camera& camera, glm::ivec2 size,
                              std::span<const int> hidden) {
  MIRRORBALL_TRY_VOID(resize(size));
  framebuffer_->bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  program_.set("clip_from_world", camera.clip_from_view * camera.view_from_world);
  program_.set("camera_position", camera.position);
  program_.set("camera_forward", camera.forward);
  program_.set("orthographic", camera.orthographic ? 1.0f : 0.0f);
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (showsHeightTexture(materialOf(scene, i), ReliefKind::exact) && !isAmong(hidden, i))
      drawInstance(scene, buffers, i);
  glCullFace(GL_BACK);
  return {};
}

void ReliefHits::drawInstance(const Scene& scene, const SceneBuffers& buffers, std::size_t instance) {
  const Material& material = materialOf(scene, instance);
  const int mesh = scene.instances[instance].mesh;
  program_.set("world_from_object", scene.instances[instance].world_from_object);
  program_.set("depth", std::abs(material.height_scale));
  program_.set("tiles", material.height_frequency);
  program_.set("instance", static_cast<int>(instance));
  program_.set("height_map", heightMapUniform(scene.height_textures[std::size_t(material.height_texture)]));
  buffers.heightsOf(scene, scene.meshes[std::size_t(mesh)]->material)->searched->heights.bind(kFreeUnit);
  buffers.drawPrisms(mesh, kNextFreeUnit);
}

}  // namespace mirrorball
