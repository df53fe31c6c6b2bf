// Part "normal" (normal_vertex.glsl). Here: bent by a height that is a function of the place (Blinn 1978).
#include "grid_random.glsl"
#include "tangent.glsl"
#include "height.glsl"

vec3 smoothNormal(SurfacePoint point) {
  vec3 bent =
      orangeNormal(point.object_position, point.object_normal, material.height_scale, material.height_frequency);
  return normalize(normal_matrix * bent);
}

float hiddenSlopes(SurfacePoint point) { return 0.0; }
