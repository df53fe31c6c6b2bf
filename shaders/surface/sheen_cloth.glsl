// Part "sheen" (sheen_none.glsl). Here: some (KHR_materials_sheen), whose light is gathered from a few wide lobes.
#include "brdf_look_up.glsl"
#include "charlie.glsl"

void layCloth(inout Surface s, SurfacePoint point) {
  s.material.sheen_color *= sheen_color_map_at(point).xyz;
  s.material.sheen_roughness *= sheen_roughness_map_at(point).w;
  s.sheen_albedo =
      sheenAlbedo(brdf_table, s.material.sheen_roughness, clamp(-dot(point.ray, s.normal), 0.0, 1.0));
}

vec3 lightOnCloth(Surface s, SurfacePoint point) {
  float alpha = alphaOfSheen(s.material.sheen_roughness);
  vec3 b = cross(s.normal, s.tangent);
  vec3 v = eyeInFrame(s, point.ray);
  vec3 light = vec3(0.0);
  float weight = 0.0;
  for (int i = 0; i < kSheenRings * kSheenSpokes; ++i) {
    SheenTap tap = sheenTap(alpha, v, i / kSheenSpokes, i % kSheenSpokes);
    vec3 d = tap.light.x * s.tangent + tap.light.y * b + tap.light.z * s.normal;
    light += tap.weight * lightOfWideLobe(point.position, d, kSheenTapRoughness);
    weight += tap.weight;
  }
  return light / max(weight, 1e-12);
}
