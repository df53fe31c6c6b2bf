#include "mirrorball/render/surface/opaque_picture.h"

#include <utility>

#include "mirrorball/gl/framebuffer.h"

namespace mirrorball {
namespace {

enum Unit { kPicture, kNearness };

}  // namespace

Result<OpaquePicture> OpaquePicture::make(gl::Api api) {
  MIRRORBALL_TRY(program, gl::Program::load(api, "screen.vert", "opaque_picture.frag"));
  program.set("picture", kPicture);
  program.set("nearness", kNearness);
  return OpaquePicture(std::move(program));
}

Result<void> OpaquePicture::take(const gl::Texture& picture, const gl::Texture& nearness) {
  if (!picture_ || picture_->width() != picture.width() || picture_->height() != picture.height()) {
    MIRRORBALL_TRY(
        made, gl::Texture::make2d(gl::Format::rgba16f, picture.width(), picture.height(), gl::Texture::kAllLevels));
    picture_ = std::move(made);
  }
  gl::drawOverAll();
  picture.bind(kPicture);
  nearness.bind(kNearness);
  target_.bind(*picture_, 0, 0);
  program_.use();
  screen_.draw(3);
  picture_->makeLevels();
  return {};
}

}  // namespace mirrorball
