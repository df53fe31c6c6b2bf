// Part "look-up": the light that a surface reflects, by the coordinates that address it.
//   vec3 reflectedLight(Surface s, SurfacePoint point)
// Here: the coordinates are a direction of the environment. A pixel sees a patch of directions; where that is long, it
// may be read piece by piece (filter_kind.glsl).
#include "filter_kind.glsl"

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec4 str = look_up_matrix * lookUpCoordinates(point, s.normal);
  vec3 d = normalize(str.xyz);
  vec3 across = dFdx(d);
  vec3 down = dFdy(d);
  float footprint = sampleFootprint(across, down, samples_per_pixel);
  vec3 along = (dot(across, across) > dot(down, down) ? across : down) / sqrt(samples_per_pixel);
  float longer = length(along);
  int reads = texture_filter == kFilterAnisotropic
                  ? readsAlong(longer * texels_per_radian, footprint / max(longer, 1e-12) * texels_per_radian)
                  : 1;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < reads; ++i)
    sum += incomingLight(point.position, normalize(d + placeOfRead(i, reads) * along), s.material.perceptual_roughness,
                         footprint / float(reads));
  return sum / float(reads);
}
