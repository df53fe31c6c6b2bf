// The light of a patch of directions of the environment, which a pixel sees. Where it is long, it may be read piece
// by piece (filter_kind.glsl).
#include "filter_kind.glsl"
#include "microfacet.glsl"

vec3 lookUpDirection(SurfacePoint point, vec3 n) {
  vec4 str = look_up_matrix * lookUpCoordinates(point, n);
  return normalize(str.xyz);
}

struct Patch {
  vec3 along;       // its longer way
  float footprint;  // sr
};

//   across, down   how the direction changes to the next pixels
Patch patchOf(vec3 across, vec3 down) {
  vec3 along = (dot(across, across) > dot(down, down) ? across : down) / sqrt(samples_per_pixel);
  return Patch(along, sampleFootprint(across, down, samples_per_pixel));
}

// How many reads along its longer way cover it. One lobe covers about α [rad] by itself: what a patch as long as that
// adds to its variance is 3 % (of slopes whose median is α: roughnessOverPatch).
int readsOfPatch(Patch area, float perceptual_roughness) {
  float longer = length(area.along);
  float shorter = max(area.footprint / max(longer, 1e-12), alphaFromPerceptualRoughness(perceptual_roughness));
  return readsAlong(longer * texels_per_radian, shorter * texels_per_radian);
}

vec3 lightOfPatch(SurfacePoint point, vec3 d, Patch area, float perceptual_roughness) {
  if (TEXTURE_FILTER != kFilterAnisotropic)
    return lightOfLobe(point.position, d, perceptual_roughness, area.footprint);
  int reads = readsOfPatch(area, perceptual_roughness);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < reads; ++i)
    sum += lightOfLobe(point.position, normalize(d + placeOfRead(i, reads) * area.along), perceptual_roughness,
                       area.footprint / float(reads));
  return sum / float(reads);
}
