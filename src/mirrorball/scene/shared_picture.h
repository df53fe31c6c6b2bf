#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "mirrorball/base/shared.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// A picture that is shared by its copies. It is read as an Image8 is.
class SharedPicture : public Shared<Image8> {
 public:
  using Shared::Shared;

  int width() const { return (*this)->width(); }
  int height() const { return (*this)->height(); }
  int channels() const { return (*this)->channels(); }
  bool empty() const { return (*this)->empty(); }
  std::size_t texelCount() const { return (*this)->texelCount(); }
  std::span<const std::uint8_t> samples() const { return (*this)->samples(); }
  const std::uint8_t* texel(int x, int y) const { return (*this)->texel(x, y); }
};

}  // namespace mirrorball
