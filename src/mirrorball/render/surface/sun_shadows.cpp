#include "mirrorball/render/surface/sun_shadows.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "formula/tangent.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/surface/texture_units.h"

namespace mirrorball {
namespace {

bool letsSunThrough(const Material& material) {
  const bool is_thin = material.alpha_mode == AlphaMode::blend && material.opacity < 0.5f;
  return is_thin || material.transmission > 0.5f;
}

/// From the sun, with the scene from −1 to 1.
glm::mat4 clipFromWorld(const formula::Sun& sun, const BoundingSphere& bounds) {
  const float radius = bounds.radius;
  const glm::mat4 view =
      glm::lookAt(bounds.center + radius * sun.towards, bounds.center, formula::anyTangent(sun.towards));
  return glm::ortho(-radius, radius, -radius, radius, 0.0f, 2.0f * radius) * view;
}

}  // namespace

int sunShadowSide(glm::ivec2 size_px, std::size_t suns, int longest) {
  const auto wanted = static_cast<unsigned>(std::max(size_px.x, size_px.y)) * 3 / 2;
  const int most = suns == 1 ? 4096 : 2048;
  return std::min(std::clamp(static_cast<int>(std::bit_ceil(wanted)), 256, most), longest / static_cast<int>(suns));
}

Result<SunShadows> SunShadows::make(gl::Api api) {
  MIRRORBALL_TRY(program, gl::Program::load(api, "sun_shadow.vert", "sun_shadow.frag"));
  program.set("base_color_map", kFreeUnit);
  return SunShadows(std::move(program));
}

Result<void> SunShadows::draw(const Scene& scene, SceneBuffers& buffers, std::span<const formula::Sun> suns,
                              const BoundingSphere& bounds, int side_px) {
  const glm::ivec2 size(side_px * static_cast<int>(suns.size()), side_px);
  MIRRORBALL_TRY_VOID(gl::resize(framebuffer_, gl::Format::rgba8, size, gl::Depths::alone));
  // What was drawn last may have read the picture there.
  glActiveTexture(GL_TEXTURE0 + kFreeUnit);
  glBindTexture(GL_TEXTURE_2D, 0);
  framebuffer_->bind();
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
  glFrontFace(GL_CCW);
  rows_.clear();
  // A little larger, so that what touches the sphere is within.
  const BoundingSphere around{bounds.center, std::max(1.01f * bounds.radius, 1e-20f)};
  for (std::size_t i = 0; i < suns.size(); ++i) {
    glViewport(static_cast<int>(i) * side_px, 0, side_px, side_px);
    const glm::mat4 clip_from_world = clipFromWorld(suns[i], around);
    drawFrom(scene, buffers, clip_from_world);
    const glm::mat4 rows = glm::transpose(clip_from_world);
    for (int row = 0; row < 3; ++row) rows_.push_back(0.5f * rows[row] + glm::vec4(0.0f, 0.0f, 0.0f, 0.5f));
  }
  return {};
}

void SunShadows::drawFrom(const Scene& scene, SceneBuffers& buffers, const glm::mat4& clip_from_world) {
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Material& material = materialOf(scene, i);
    if (letsSunThrough(material)) continue;
    if (material.double_sided)
      glDisable(GL_CULL_FACE);
    else
      glEnable(GL_CULL_FACE);
    program_.set("clip_from_object", clip_from_world * scene.instances[i].world_from_object);
    setHoles(buffers, material);
    program_.use();
    buffers.drawMesh(scene.instances[i].mesh);
  }
}

/// Where a material is cut away.
void SunShadows::setHoles(const SceneBuffers& buffers, const Material& material) {
  const TextureSlot& slot = material.base_color_map;
  const bool has_holes = material.alpha_mode != AlphaMode::opaque;
  const bool has_map =
      has_holes && slot.texture >= 0 && buffers.bindTexture(static_cast<std::size_t>(slot.texture), kFreeUnit);
  program_.set("has_map", static_cast<int>(has_map));
  const glm::mat2 matrix = uvMatrix(slot);
  program_.set("map_matrix", glm::vec4(matrix[0], matrix[1]));
  program_.set("map_offset", glm::vec3(slot.offset, static_cast<float>(slot.uv_set)));
  const float solid_from = material.alpha_mode == AlphaMode::mask ? material.alpha_cutoff : 0.5f;
  program_.set("alpha", glm::vec2(material.opacity, has_holes ? solid_from : 0.0f));
}

}  // namespace mirrorball
