// Part "detail" (detail_none.glsl). Here: a normal map in tangent space.
#include "tangent.glsl"

vec3 detailedNormal(SurfacePoint point, vec3 n) {
  vec3 mapped = decodedNormal(normal_map_at(point).xyz, normal_zero());
  return mappedNormal(point.tangent, n, mapped, material.normal_scale);
}

float hiddenDetail(SurfacePoint point) { return spreadOfAlpha(normal_map_at(point).w, material.normal_scale); }
