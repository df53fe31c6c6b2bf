// A clear coat (KHR_materials_clearcoat), whose normal coatNormal(point) says, and
// hiddenInCoat(point) what of it a pixel averages away.
#include "brdf_look_up.glsl"
#include "clear_coat.glsl"
#include "tangent.glsl"

vec3 coated(Surface s, SurfacePoint point, vec3 light) {
  float share = s.material.clearcoat * clearcoat_map_at(point).x;
  s.material.clearcoat_roughness =
      widenedRoughness(s.material.clearcoat_roughness * clearcoat_roughness_map_at(point).y, hiddenInCoat(point));
  vec3 outward = coatNormal(point);
  vec3 n = facingNormal(seesFront() ? outward : -outward, point.ray);
  float cosine = clamp(-dot(point.ray, n), 0.0, 1.0);
  Surface coat = coatOf(s, point.ray, n, anyTangent(n),
                        environmentBrdf(brdf_table, s.material.clearcoat_roughness, cosine));
  vec3 shown =
      litByEnvironment(coat, point, vec3(0.0), vec3(0.0)) + lightOfLamps(coat, point) + reflectedSuns(coat, point);
  return underCoat(coat, share, light, shown);
}
