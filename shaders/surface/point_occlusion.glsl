// Part "point" (point_raster.glsl). Here: below the mesh, on a straight surface between two of equal steps.
#include "relief_point.glsl"

float searchedDepth(ReliefRay ray, float cosine) {
  return occlusionDepth(heights, heightMap(), ray, int(height_form.y));
}
