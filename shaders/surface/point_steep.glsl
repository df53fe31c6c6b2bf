// Part "point" (point_raster.glsl). Here: below the mesh, at the first of equal steps that is below the surface.
#include "relief_point.glsl"

float searchedDepth(ReliefRay ray, float cosine) { return steepDepth(heights, heightMap(), ray, int(height_form.y)); }
