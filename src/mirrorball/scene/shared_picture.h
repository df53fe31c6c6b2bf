#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// A picture that is shared by its copies, so that a scene with large textures is copied at once. It is read as an
/// Image8 is.
class SharedPicture {
 public:
  SharedPicture() : SharedPicture(Image8()) {}
  SharedPicture(Image8 picture) : picture_(std::make_shared<Image8>(std::move(picture))) {}

  // Without moving, after which there would be no picture.
  SharedPicture(const SharedPicture&) = default;
  SharedPicture& operator=(const SharedPicture&) = default;

  operator const Image8&() const { return *picture_; }
  int width() const { return picture_->width(); }
  int height() const { return picture_->height(); }
  int channels() const { return picture_->channels(); }
  bool empty() const { return picture_->empty(); }
  std::size_t texelCount() const { return picture_->texelCount(); }
  std::span<const std::uint8_t> samples() const { return std::as_const(*picture_).samples(); }
  const std::uint8_t* texel(int x, int y) const { return std::as_const(*picture_).texel(x, y); }

  /// To be changed, which other copies are not.
  Image8& edit() {
    if (picture_.use_count() > 1) picture_ = std::make_shared<Image8>(*picture_);
    return *picture_;
  }

 private:
  std::shared_ptr<Image8> picture_;
};

}  // namespace mirrorball
