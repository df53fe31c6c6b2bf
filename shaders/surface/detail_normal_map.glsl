// Part "detail" (detail_none.glsl). Here: a normal map in tangent space.
#include "tangent.glsl"

vec3 detailedNormal(SurfacePoint point, vec3 n) {
  vec3 t = normalize(point.tangent.xyz - n * dot(n, point.tangent.xyz));
  vec3 b = cross(n, t) * point.tangent.w;
  return normalFromMap(t, b, n, normal_map_at(point).xyz, material.normal_scale);
}
