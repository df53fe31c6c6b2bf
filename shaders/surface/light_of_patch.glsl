// The light of a patch of directions of the environment, which a pixel sees. Where it is long, it may be read piece
// by piece (filter_kind.glsl).
//   across, down   how d changes to the next pixels
#include "filter_kind.glsl"

vec3 lookUpDirection(SurfacePoint point, vec3 n) {
  vec4 str = look_up_matrix * lookUpCoordinates(point, n);
  return normalize(str.xyz);
}

struct PatchReads {
  vec3 along;       // the patch, its longer way
  int count;
  float footprint;  // of each, in sr
};

PatchReads readsOfPatch(vec3 across, vec3 down) {
  float footprint = sampleFootprint(across, down, samples_per_pixel);
  vec3 along = (dot(across, across) > dot(down, down) ? across : down) / sqrt(samples_per_pixel);
  float longer = length(along);
  int reads = texture_filter == kFilterAnisotropic
                  ? readsAlong(longer * texels_per_radian, footprint / max(longer, 1e-12) * texels_per_radian)
                  : 1;
  return PatchReads(along, reads, footprint / float(reads));
}

vec3 lightOfReads(SurfacePoint point, vec3 d, PatchReads reads, float perceptual_roughness) {
  if (reads.count == 1) return incomingLight(point.position, d, perceptual_roughness, reads.footprint);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < reads.count; ++i)
    sum += incomingLight(point.position, normalize(d + placeOfRead(i, reads.count) * reads.along), perceptual_roughness,
                         reads.footprint);
  return sum / float(reads.count);
}

vec3 lightOfPatch(SurfacePoint point, vec3 d, vec3 across, vec3 down, float perceptual_roughness) {
  return lightOfReads(point, d, readsOfPatch(across, down), perceptual_roughness);
}
