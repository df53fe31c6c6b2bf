#pragma once

#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// For each texel of a row the square of the slope [height / texel] of the steepest way from its centre up to any part
/// of the surface: by a search in the pyramid for as many texels at once as vectors have lanes. A node is passed over
/// where even its highest point, as near as any of its points, is not above the steepest way that is known of any of
/// them.
///
/// maxima      of maximumPyramid
/// min_square  the least answer
/// squares     a number for each texel
void writeSteepestWays(const Image& heights, const ImageSet& maxima, MapEdges edges, int y, float min_square,
                       float* squares);

}  // namespace mirrorball
