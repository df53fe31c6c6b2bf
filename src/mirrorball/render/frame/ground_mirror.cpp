#include "mirrorball/render/frame/ground_mirror.h"

#include <algorithm>

#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>

#include "formula/bsdf.h"

namespace mirrorball {
namespace {

/// Of a pixel, of all its samples together, and the fewest of one sample.
constexpr int kTapsOfPixel = 16;
constexpr int kLeastTaps = 4;

constexpr int kLevels = 7;  // of the picture: the last has texels of 64 pixels

/// From a camera's clip space: pixels, and the depth from 0 to 1.
glm::mat4 texelsFromClip(glm::vec2 size) {
  const glm::vec3 half(size / 2.0f, 0.5f);
  return glm::scale(glm::translate(glm::mat4(1.0f), half), half);
}

}  // namespace

Result<GroundMirror> GroundMirror::make(gl::Api api, ProxyUniforms& proxy) {
  MIRRORBALL_TRY(program, gl::Program::load(api, "screen.vert", "ground_mirror.frag"));
  proxy.connectBlock(program);
  program.set("mirror_picture", TextureUnit::mirror_picture);
  program.set("mirror_depths", TextureUnit::mirror_depths);
  MIRRORBALL_TRY(to_halves, gl::Program::load(api, "screen.vert", "half_picture.frag"));
  to_halves.set("picture", TextureUnit::mirror_picture);
  return GroundMirror(std::move(program), std::move(to_halves));
}

Result<const gl::Framebuffer*> GroundMirror::begin(const Camera& camera, float ground, const BoundingSphere& bounds,
                                                   glm::ivec2 size) {
  below_ = mirroredBelow(camera, ground, bounds);
  if (!picture_ || picture_->width() != size.x || picture_->height() != size.y) {
    MIRRORBALL_TRY(made, gl::Framebuffer::make(gl::Format::rgba32f, size.x, size.y, true));
    picture_ = std::move(made);
  }
  return &*picture_;
}

Result<void> GroundMirror::finish(bool is_blurred) {
  if (!halves_ || halves_->width() != picture_->width() || halves_->height() != picture_->height()) {
    MIRRORBALL_TRY(made,
                   gl::Framebuffer::make(gl::Format::rgba16f, picture_->width(), picture_->height(), false, kLevels));
    halves_ = std::move(made);
  }
  halves_->bind();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  picture_->color().bind(TextureUnit::mirror_picture);
  to_halves_.use();
  screen_.draw(3);
  if (is_blurred) halves_->makeLevels();
  return {};
}

void GroundMirror::draw(const FrameUniforms& frame, const FrameSettings& settings, const Box& scene) {
  const Camera& camera = frame.camera;
  const float alpha = formula::alphaFromPerceptualRoughness(settings.proxy.ground_roughness);
  const int taps = alpha > 0.0f ? std::max(kTapsOfPixel / settings.samples, kLeastTaps) : 1;
  const glm::mat4 clip_from_directions = camera.clip_from_view * glm::mat4(glm::mat3(camera.view_from_world));
  program_.set("world_from_clip", glm::inverse(clip_from_directions));
  program_.set("camera_position", camera.position);
  program_.set("camera_forward", camera.forward);
  program_.set("orthographic", camera.orthographic ? 1.0f : 0.0f);
  program_.set("picture_from_world", texelsFromClip({picture_->width(), picture_->height()}) * below_.clip_from_view *
                                         below_.view_from_world);
  program_.set("scene_low", scene.low);
  program_.set("scene_high", scene.high);
  program_.set("alpha", alpha);
  program_.set("taps", taps);
  program_.set("first_tap", frame.sample * taps);
  program_.set("taps_of_pixel", static_cast<float>(taps * settings.samples));
  program_.set("pixels_per_slope", 0.5f * static_cast<float>(picture_->height()) * camera.clip_from_view[1][1]);
  halves_->color().bind(TextureUnit::mirror_picture);
  picture_->depth().bind(TextureUnit::mirror_depths);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  screen_.draw(3);
  glDisable(GL_BLEND);
}

}  // namespace mirrorball
