// Part "detail" (detail_none.glsl). Here: a normal map in the mesh's own space.
#include "tangent.glsl"

vec3 detailedNormal(SurfacePoint point, vec3 n) {
  return objectMappedNormal(normal_matrix, n, normal_map_at(point).xyz, material.normal_scale);
}

float hiddenDetail(SurfacePoint point) { return spreadOfAlpha(normal_map_at(point).w, material.normal_scale); }
