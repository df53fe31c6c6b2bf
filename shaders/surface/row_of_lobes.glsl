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

// A part of the light that a surface reflects.
struct Look {
  vec3 direction;
  Patch area;
  float perceptual_roughness;
  vec3 weight;
};

vec3 lightOfLook(SurfacePoint point, Look look) {
  return look.weight * lightOfPatch(point, look.direction, look.area, look.perceptual_roughness);
}

// How many parts the light of a row has: one for each lobe. Of a smooth coat the compiler knows that it is sharp.
int looksOfRow(Surface s) {
  bool is_sharp = HAS_SMOOTH_COAT && s.material.perceptual_roughness == 0.0;
  return is_sharp ? 1 : LOBE_TAPS;
}

//   d   where the mirror direction is looked up
Look lookOfRow(Surface s, SurfacePoint point, vec3 d, Patch area, int lobe) {
  float roughness = s.material.perceptual_roughness;
  if (looksOfRow(s) == 1) return Look(d, area, roughness, vec3(1.0));
  vec3 r = reflect(point.ray, s.normal);
  float cosine = clamp(dot(r, s.normal), 0.0, 1.0);
  vec4 texel = lobeRowTexel(firstOfRow(LOBE_TAPS) + lobe, roughness, cosine);
  RoundLobe round = lobeOfRow(texel, roughness, s.normal, r);
  vec3 weight = mix(vec3(round.weight), vec3(round.grazing_weight), s.reflectance.grazing);
  vec4 of_lobe = look_up_matrix * vec4(round.direction, 1.0);
  return Look(normalize(of_lobe.xyz), patchOfLobe(area, lobe), round.perceptual_roughness, weight);
}
