// Part "point" (point_raster.glsl). Here: guessed from the height where the ray enters.
#include "relief_point.glsl"

float searchedDepth(ReliefRay ray, float cosine) { return parallaxDepth(heights, heightMap(), ray, cosine); }
