// Part "point" (point_raster.glsl). Here: below the mesh, by steps as wide as the space above the surface.
#include "relief_point.glsl"

float searchedDepth(ReliefRay ray, float cosine) { return coneDepth(heights, heightMap(), ray, int(height_form.y)); }
