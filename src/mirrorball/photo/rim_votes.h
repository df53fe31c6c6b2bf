#pragma once

#include <vector>

#include "mirrorball/image/image.h"
#include "mirrorball/photo/pinhole.h"

namespace mirrorball {

/// Circles that many edges of a picture speak for, the best of each size first.
///
/// Each edge votes for the centres that lie along its gradient (Hough's transform with gradients: Kimme, Ballard &
/// Sklansky 1975). Votes are cast in a pyramid of halved pictures, always for radii of about 10 to 24 pixels: there the
/// gradient's direction is as exact as the cells are small, and a ball's reflections are small beside its rim.
///
/// grey     one channel, brightness 0 … 1
/// returns  circles in pixels of `grey`, at most 12 a level of the pyramid
std::vector<Circle> voteForCircles(const Image& grey);

}  // namespace mirrorball
