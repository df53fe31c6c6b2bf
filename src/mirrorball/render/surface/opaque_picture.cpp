#include "mirrorball/render/surface/opaque_picture.h"

#include <utility>

#include "mirrorball/render/surface/eye_ray.h"

namespace mirrorball {
namespace {

enum Unit { kPicture, kDepths };

}  // namespace

Result<OpaquePicture> OpaquePicture::make(gl::Api api) {
  MIRRORBALL_TRY(program, gl::Program::load(api, "screen.vert", "opaque_picture.frag"));
  program.set("picture", kPicture);
  program.set("depths", kDepths);
  return OpaquePicture(std::move(program));
}

Result<void> OpaquePicture::resize(glm::ivec2 size, int levels) {
  if (picture_ && size == glm::ivec2(picture_->width(), picture_->height()) && levels_ == levels) return {};
  MIRRORBALL_TRY(made, gl::Texture::make2d(gl::Format::rgba16f, size.x, size.y, levels));
  picture_ = std::move(made);
  levels_ = levels;
  return {};
}

void OpaquePicture::take(const gl::Framebuffer& picture, const Camera& camera, float unit) {
  gl::drawOverAll();
  picture.color().bind(kPicture);
  picture.depth().bind(kDepths);
  target_.bind(*picture_, 0, 0);
  program_.set("eye_from_texels", eyeFromTexels(camera, {picture.width(), picture.height()}));
  program_.set("unit", unit);
  program_.use();
  screen_.draw(3);
  if (picture_->levels() > 1) picture_->makeLevels();
}

}  // namespace mirrorball
