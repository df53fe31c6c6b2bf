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

// Each lobe sees a part of the patch of its own. Where the patch is wider than the lobes, as on small polished things,
// they are as many reads of it; where it is narrower it does not matter which part it is.
Patch patchOfLobe(Patch area, int lobe) {
  int part = partOfLobe(lobe, LOBE_TAPS, int(sample_phase * samples_per_pixel), int(samples_per_pixel));
  if (part < 0) return area;
  vec2 size = vec2(2.0 / float(LOBE_TAPS), 0.5);
  return partOfPatch(area, (vec2(part / 2, part % 2) + 0.5) * size - 0.5, size);
}

//   d   where the mirror direction is looked up
vec3 lightOfRow(Surface s, SurfacePoint point, vec3 d, Patch area) {
  float roughness = s.material.perceptual_roughness;
  // Of a smooth coat the compiler knows it.
  bool is_sharp = HAS_SMOOTH_COAT && roughness == 0.0;
  if (LOBE_TAPS == 1 || is_sharp) return lightOfPatch(point, d, area, roughness);
  vec3 r = reflect(point.ray, s.normal);
  float cosine = clamp(dot(r, s.normal), 0.0, 1.0);
  vec3 light = vec3(0.0);
  vec3 weights = vec3(0.0);
  for (int i = 0; i < LOBE_TAPS; ++i) {
    vec4 texel = lobeRowTexel(firstOfRow(LOBE_TAPS) + i, roughness, cosine);
    RoundLobe lobe = lobeOfRow(texel, roughness, s.normal, r);
    vec3 weight = mix(vec3(lobe.weight), vec3(lobe.grazing_weight), s.reflectance.grazing);
    vec4 of_lobe = look_up_matrix * vec4(lobe.direction, 1.0);
    light += weight * lightOfPatch(point, normalize(of_lobe.xyz), patchOfLobe(area, i), lobe.perceptual_roughness);
    weights += weight;
  }
  return light / weights;
}
