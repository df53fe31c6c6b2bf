#pragma once

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// Bounds of a height field from above, coarser from level to level, by which a ray skips what it passes over.
///
/// The surface is the one that bilinear filtering shows: patch (i, j) spans the centres of the texels i and i + 1
/// across and j and j + 1 down, that is u from (i + ½) / width to (i + 1½) / width. It never rises above its four
/// corners. The last patch of a row lies between the last texel and the first of the next tile, or is flat where edges
/// are clamped; where they are tiled, a place left of the first centre is in the last patch.
///
/// Level 0 has a cell for each patch: the maximum of its corners. A cell (i, j) of the level L + 1 is the maximum of
/// the cells (2 i, 2 j) to (2 i + 1, 2 j + 1) of the level L. Sides are halved and rounded down (levelSide), as the mip
/// levels of a texture are; where a side is odd, the last cell also holds the odd row or column. So patch i is in cell
/// min(i >> L, levelSide(width, L) − 1), and that cell holds the patches from i << L to the next cell's first, the last
/// one to the map's end. The last level is one cell, the maximum of all.
///
/// heights  1 channel
/// returns  levels of 1 channel, exact copies of heights
/// errors   non_finite (the first bad texel is named); too_large; interrupted
/// cost     4096² in 60 ms on two cores
/// from     Tevs, Ihrke and Seidel 2008, "Maximum mipmaps for fast, accurate, and scalable dynamic height field
///          rendering"
Result<ImageSet> maximumPyramid(const Image& heights, MapEdges edges = MapEdges::tiled,
                                const ProgressFunction& progress = {});

}  // namespace mirrorball
