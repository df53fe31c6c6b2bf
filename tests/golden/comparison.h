#pragma once

#include <string>

#include <glm/vec2.hpp>

#include "golden/cases.h"
#include "mirrorball/image/image.h"

namespace mirrorball::golden {

/// How far two pictures are apart, in codes of 0 … 255. A pixel's difference is that of its worst channel; colours
/// count by their coverage, because a transparent pixel's colour is not seen.
struct Difference {
  double maximum = 0.0;
  double mean = 0.0;       ///< over all pixels
  glm::ivec2 worst{0, 0};  ///< where the maximum lies, from the top left
};

/// "40 at (3, 2), 0.5 in the mean"
std::string textOf(const Difference& difference);

/// Compares two pictures of the same size with straight alpha (4 channels).
Difference differenceOf(const Image8& golden, const Image8& now);

/// Whether neither the maximum nor the mean is above what is allowed.
bool isWithin(const Difference& difference, const Tolerance& tolerance);

/// The picture to look at when two differ: golden | now | difference × 8, both on grey where they are transparent. Of
/// two sizes, the first two only.
Image8 contactSheet(const Image8& golden, const Image8& now);

}  // namespace mirrorball::golden
