// Part "coat" (coat_none.glsl). Here: one with a normal map of its own.
#include "tangent.glsl"
vec3 coatNormal(SurfacePoint point) {
  vec3 mapped = decodedNormal(clearcoat_normal_map_at(point).xyz, clearcoat_normal_zero());
  return mappedNormal(point.tangent, point.normal, mapped, material.clearcoat_normal_scale);
}
float hiddenInCoat(SurfacePoint point) {
  return spreadOfAlpha(clearcoat_normal_map_at(point).w, material.clearcoat_normal_scale);
}
#include "coat.glsl"
