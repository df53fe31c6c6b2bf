// Part "detail" (detail_none.glsl). Here: a normal map in tangent space.
#include "tangent.glsl"

vec3 detailedNormal(SurfacePoint point, vec3 n) {
  return mappedNormal(point.tangent, n, normal_map_at(point).xyz, material.normal_scale);
}

float hiddenDetail(SurfacePoint point) { return spreadOfAlpha(normal_map_at(point).w, material.normal_scale); }
