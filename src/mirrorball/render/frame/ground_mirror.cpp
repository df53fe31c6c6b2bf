#include "mirrorball/render/frame/ground_mirror.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "formula/bsdf.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/half.h"
#include "mirrorball/render/surface/eye_ray.h"
#include "mirrorball/render/surface/texture_units.h"

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
  proxy.connection().connectBlock(program);
  program.set("mirror_picture", kFreeUnit);
  program.set("mirror_depths", kNextFreeUnit);
  MIRRORBALL_TRY(to_halves, gl::Program::load(api, "screen.vert", "limited_picture.frag"));
  to_halves.set("picture", kFreeUnit);
  to_halves.set("factor", 1.0f);
  to_halves.set("most", gl::kLargestHalf);
  return GroundMirror(std::move(program), std::move(to_halves));
}

Result<const gl::Framebuffer*> GroundMirror::begin(const SampleUniforms& sample, float ground,
                                                   const BoundingSphere& bounds, glm::ivec2 size) {
  below_ = mirroredBelow(sample.camera, ground, bounds);
  MIRRORBALL_TRY_VOID(gl::resize(picture_, gl::Format::rgba32f, size, depthsFor(sample)));
  return &*picture_;
}

Result<void> GroundMirror::finish(bool is_blurred) {
  MIRRORBALL_TRY_VOID(
      gl::resize(halves_, gl::Format::rgba16f, {picture_->width(), picture_->height()}, gl::Depths::none, kLevels));
  halves_->bind();
  gl::drawOverAll();
  picture_->color().bind(kFreeUnit);
  to_halves_.use();
  screen_.draw(3);
  if (is_blurred) halves_->makeLevels();
  return {};
}

void GroundMirror::draw(const FrameUniforms& frame, const FrameSettings& settings, const Box& scene) {
  const Camera& camera = frame.sample.camera;
  const float alpha = formula::alphaFromPerceptualRoughness(settings.proxy.ground_roughness);
  const int taps = alpha > 0.0f ? std::max(kTapsOfPixel / settings.samples, kLeastTaps) : 1;
  setEyeRay(program_, camera);
  program_.set("picture_from_world", texelsFromClip({picture_->width(), picture_->height()}) * below_.clip_from_view *
                                         below_.view_from_world);
  program_.set("scene_low", scene.low);
  program_.set("scene_high", scene.high);
  program_.set("alpha", alpha);
  program_.set("taps", taps);
  program_.set("first_tap", frame.sample.number * taps);
  program_.set("taps_of_pixel", static_cast<float>(taps * settings.samples));
  program_.set("pixels_per_slope", 0.5f * static_cast<float>(picture_->height()) * camera.clip_from_view[1][1]);
  halves_->color().bind(kFreeUnit);
  picture_->depth().bind(kNextFreeUnit);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  screen_.draw(3);
  glDisable(GL_BLEND);
}

}  // namespace mirrorball
