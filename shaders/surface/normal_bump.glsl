// Part "normal" (normal_vertex.glsl). Here: bent by a height that is a function of the place (Blinn 1978).
#include "grid_random.glsl"
#include "tangent.glsl"
#include "height.glsl"

vec3 smoothNormal(SurfacePoint point) {
  // The height is a function of the place, so any frame will do for its two slopes.
  vec3 p_u = anyTangent(point.object_normal);
  vec3 p_v = cross(point.object_normal, p_u);
  float frequency = material.bump_frequency;
  vec3 slope = orangeHeight(point.object_position * frequency).xyz * (material.bump_height * frequency);
  vec3 bent = perturbedNormal(p_u, p_v, point.object_normal, dot(slope, p_u), dot(slope, p_v));
  return normalize(normal_matrix * bent);
}
