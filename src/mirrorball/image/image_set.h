#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// The images of one texture: `levels` mip levels, each of `faces` images (1, or 6 for a cube in the order
/// +X −X +Y −Y +Z −Z). Level 0 is the largest.
class ImageSet {
 public:
  ImageSet() = default;
  ImageSet(int levels, int faces) : levels_(levels), faces_(faces), images_(std::size_t(levels) * std::size_t(faces)) {}
  /// One level, one face.
  explicit ImageSet(Image image) : ImageSet(1, 1) { images_[0] = std::move(image); }

  int levels() const { return levels_; }
  int faces() const { return faces_; }
  bool empty() const { return images_.empty(); }

  Image& at(int level, int face) { return images_[index(level, face)]; }
  const Image& at(int level, int face) const { return images_[index(level, face)]; }

 private:
  std::size_t index(int level, int face) const {
    assert(level >= 0 && level < levels_ && face >= 0 && face < faces_);
    return std::size_t(level) * std::size_t(faces_) + std::size_t(face);
  }

  int levels_ = 0;
  int faces_ = 0;
  std::vector<Image> images_;
};

}  // namespace mirrorball
