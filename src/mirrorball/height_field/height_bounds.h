#pragma once

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// Between which heights a part of a height field lies: what its maximum pyramid and that of −h say.
class HeightBounds {
 public:
  /// Of heights of which nothing is known but that they are in [0, 1].
  HeightBounds() = default;

  /// heights  1 channel
  /// errors   non_finite (the first bad texel is named); too_large
  /// cost     as two maximum pyramids, of which two thirds of the heights' memory are kept
  static Result<HeightBounds> make(const Image& heights, MapEdges edges);

  /// No part of the bilinear surface over a rectangle is below the first or above the second.
  ///
  /// low, high   corners in texels, the centre of the first one being (0, 0); below ±1e8
  /// returns     what cells of at least two texels say that cover it, some eight across and down
  glm::vec2 over(glm::vec2 low, glm::vec2 high) const;

 private:
  glm::ivec2 size_{0};
  MapEdges edges_ = MapEdges::tiled;
  // Level 0, of single patches, is left out where there are others.
  ImageSet highest_;
  ImageSet lowest_;  // of −h, the wrong way round
};

}  // namespace mirrorball
