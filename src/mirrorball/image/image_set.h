#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// The images of one texture: `levels` mip levels, each of `layers` array elements (1 unless it is an array), each of
/// `faces` images (1, or 6 for a cube in the order +X −X +Y −Y +Z −Z). Level 0 is the largest.
class ImageSet {
 public:
  ImageSet() = default;
  ImageSet(int levels, int faces, int layers = 1)
      : levels_(levels),
        layers_(layers),
        faces_(faces),
        images_(std::size_t(levels) * std::size_t(layers) * std::size_t(faces)) {}
  /// One level, one layer, one face.
  explicit ImageSet(Image image) : ImageSet(1, 1) { images_[0] = std::move(image); }

  int levels() const { return levels_; }
  int layers() const { return layers_; }
  int faces() const { return faces_; }
  bool empty() const { return images_.empty(); }

  Image& at(int level, int face, int layer = 0) { return images_[index(level, face, layer)]; }
  const Image& at(int level, int face, int layer = 0) const { return images_[index(level, face, layer)]; }

 private:
  std::size_t index(int level, int face, int layer) const {
    assert(level >= 0 && level < levels_ && face >= 0 && face < faces_ && layer >= 0 && layer < layers_);
    return (std::size_t(level) * std::size_t(layers_) + std::size_t(layer)) * std::size_t(faces_) + std::size_t(face);
  }

  int levels_ = 0;
  int layers_ = 0;
  int faces_ = 0;
  std::vector<Image> images_;
};

/// Calls `visit(image)` for every image of a set, level by level.
template <typename Set, typename Visit>
void forEachImage(Set& images, const Visit& visit) {
  for (int level = 0; level < images.levels(); ++level)
    for (int layer = 0; layer < images.layers(); ++layer)
      for (int face = 0; face < images.faces(); ++face) visit(images.at(level, face, layer));
}

/// The side of a mip level whose level 0 has `side` texels: halved and rounded down, at least 1.
inline int levelSide(int side, int level) { return std::max(side >> level, 1); }

/// The number of levels down to one texel, for images whose longer side has that many texels.
inline int levelCount(int longer_side) { return static_cast<int>(std::bit_width(static_cast<unsigned>(longer_side))); }

}  // namespace mirrorball
