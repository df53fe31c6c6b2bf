// The light that a rough surface reflects at any angle, from a row of round lobes in the plane of incidence
// (formula/bsdf/lobe_row.glsl).
#include "brdf_look_up.glsl"
#include "lobe_row.glsl"
#include "light_of_patch.glsl"

// The rows stand to the right of the square of the BRDF table.
vec4 lobeRowTexel(int lobe, float perceptual_roughness, float cosine) {
  vec2 size = vec2(textureSize(brdf_table, 0));
  vec2 place = vec2(size.y, 0.0) + placeInLobeRows(lobe, perceptual_roughness, cosine);
  return textureLod(brdf_table, place / size, 0.0);
}

//   across, down   how the mirror direction changes to the next pixels
vec3 lightOfRow(Surface s, SurfacePoint point, vec3 across, vec3 down) {
  float roughness = s.material.perceptual_roughness;
  if (lobe_taps == 1 || roughness <= 0.0)
    return lightOfPatch(point, lookUpDirection(point, s.normal), across, down, roughness);
  PatchReads reads = readsOfPatch(across, down);
  vec3 r = reflect(point.ray, s.normal);
  float cosine = clamp(dot(r, s.normal), 0.0, 1.0);
  vec3 light = vec3(0.0);
  vec3 weights = vec3(0.0);
  for (int i = 0; i < lobe_taps; ++i) {
    vec4 texel = lobeRowTexel(firstOfRow(lobe_taps) + i, roughness, cosine);
    RoundLobe lobe = lobeOfRow(texel, roughness, s.normal, r);
    vec3 weight = mix(vec3(lobe.weight), vec3(lobe.grazing_weight), s.reflectance.grazing);
    vec4 d = look_up_matrix * vec4(lobe.direction, 1.0);
    light += weight * lightOfReads(point, normalize(d.xyz), reads, lobe.perceptual_roughness);
    weights += weight;
  }
  return light / weights;
}
