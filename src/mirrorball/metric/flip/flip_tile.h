#pragma once

#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "mirrorball/image/image.h"
#include "mirrorball/metric/flip/flip_filters.h"

namespace mirrorball::flip {

/// A part of a picture that is looked at by itself, so that what it needs stays in a core's cache.
struct Tile {
  int left;
  int top;
  int width;
  int height;
};

/// The tiles that cover a picture, row by row.
std::vector<Tile> tilesOf(int width, int height);

/// What FLIP's observer sees of a pixel.
struct SeenPixel {
  glm::vec3 lab;  ///< its colour, of what the eye resolves
  float edge;     ///< how much of an edge it is
  float point;    ///< how much of a point
};

/// What is seen of a tile's pixels, row by row. What lies beside the picture is as its nearest pixel.
///
/// shown    linear light in [0, 1] that a display sends for a texel
std::vector<SeenPixel> seenThrough(const Filters& filters, const Tile& tile, const Image& image,
                                   const std::function<glm::vec3(glm::vec3 light)>& shown);

}  // namespace mirrorball::flip
