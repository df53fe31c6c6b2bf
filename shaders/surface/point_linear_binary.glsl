// Part "point" (point_raster.glsl). Here: below the mesh, between two of equal steps by halves.
#include "relief_point.glsl"

float searchedDepth(ReliefRay ray, float cosine) { return binaryDepth(heights, heightMap(), ray, int(height_form.y)); }
