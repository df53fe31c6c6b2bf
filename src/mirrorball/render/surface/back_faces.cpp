#include "mirrorball/render/surface/back_faces.h"

#include <algorithm>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "formula/bodies.h"
#include "mirrorball/gl/gl_api.h"

namespace mirrorball {
namespace {

/// How much more than the frame is drawn on each side, if the driver takes as much.
int marginOf(glm::ivec2 size) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const int longer = std::max(size.x, size.y);
  return std::clamp((largest - longer) / 2, 0, (longer + 7) / 8);
}

}  // namespace

Result<BackFaces> BackFaces::make(gl::Api api) {
  MIRRORBALL_TRY(program, gl::Program::load(api, "back_faces.vert", "back_faces.frag"));
  return BackFaces(std::move(program));
}

Result<void> BackFaces::resize(glm::ivec2 size) {
  return gl::resize(framebuffer_, gl::Format::rgba32f, size + 2 * marginOf(size), gl::Depths::alone);
}

Result<void> BackFaces::draw(const Scene& scene, const SceneBuffers& buffers, const Camera& camera, glm::ivec2 size,
                             std::span<const int> hidden) {
  MIRRORBALL_TRY_VOID(resize(size));
  const glm::ivec2 drawn(framebuffer_->width(), framebuffer_->height());
  const glm::dvec3 shown(glm::dvec2(size) / glm::dvec2(drawn), 1.0);
  const glm::dmat4 clip_from_view = glm::scale(glm::dmat4(1.0), shown) * glm::dmat4(camera.clip_from_view);
  const glm::dvec3 half(glm::dvec2(drawn) / 2.0, 1.0);
  const glm::dmat4 texels_from_clip =
      glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(half.x, half.y, 0.0)), half);
  const glm::dmat4 view_from_world(camera.view_from_world);
  texels_from_world_ = texels_from_clip * clip_from_view * view_from_world;
  eye_from_texels_ = glm::inverse(texels_from_clip * clip_from_view * glm::dmat4(glm::dmat3(view_from_world)));

  framebuffer_->bind();
  glClearColor(0.0f, 0.0f, formula::kNoBackFace, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  program_.set("clip_from_world", glm::mat4(clip_from_view * view_from_world));
  program_.set("camera_position", camera.position);
  program_.set("camera_forward", camera.forward);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (!isBody(materialOf(scene, i)) || isAmong(hidden, i)) continue;
    const glm::mat4& world_from_object = scene.instances[i].world_from_object;
    program_.set("world_from_object", world_from_object);
    program_.set("normal_matrix", glm::transpose(glm::inverse(glm::mat3(world_from_object))));
    buffers.drawMesh(scene.instances[i].mesh);
  }
  glCullFace(GL_BACK);
  return {};
}

}  // namespace mirrorball
