// The light of a patch of directions of the environment, which a pixel sees. Where it is long, it may be read piece
// by piece (filter_kind.glsl).
//   across, down   how d changes to the next pixels
#include "filter_kind.glsl"

vec3 lookUpDirection(SurfacePoint point, vec3 n) {
  vec4 str = look_up_matrix * lookUpCoordinates(point, n);
  return normalize(str.xyz);
}

vec3 lightOfPatch(SurfacePoint point, vec3 d, vec3 across, vec3 down, float perceptual_roughness) {
  float footprint = sampleFootprint(across, down, samples_per_pixel);
  vec3 along = (dot(across, across) > dot(down, down) ? across : down) / sqrt(samples_per_pixel);
  float longer = length(along);
  int reads = texture_filter == kFilterAnisotropic
                  ? readsAlong(longer * texels_per_radian, footprint / max(longer, 1e-12) * texels_per_radian)
                  : 1;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < reads; ++i)
    sum += incomingLight(point.position, normalize(d + placeOfRead(i, reads) * along), perceptual_roughness,
                         footprint / float(reads));
  return sum / float(reads);
}
