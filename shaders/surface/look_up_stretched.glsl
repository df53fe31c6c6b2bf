// Part "look-up" (look_up_environment.glsl). Here: the roughness may be stretched along the tangent, so that the light
// comes from a row of round lobes.
#include "ggx.glsl"
#include "stretched_lobe.glsl"

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec2 alpha = stretchedAlpha(s.material.perceptual_roughness, s.material.anisotropy);
  vec3 v = eyeInFrame(s, point.ray);
  vec3 mirrored = reflect(point.ray, s.normal);
  float footprint = sampleFootprint(dFdx(mirrored), dFdy(mirrored), samples_per_pixel);
  vec3 light = vec3(0.0);
  float weight = 0.0;
  int taps = s.material.anisotropy > 0.0 ? kTapsOfStretchedLobe : 1;
  for (int i = 0; i < taps; ++i) {
    // Each sample of a pixel has shares of its own.
    float share = (float(i) + (taps == 1 ? 0.5 : sample_phase)) / float(taps);
    FacetTap tap = tapOfStretchedLobe(alpha, v, share, 1.0 / (float(taps) * samples_per_pixel));
    if (tap.weight <= 0.0) continue;
    vec3 h = tap.normal.x * s.tangent + tap.normal.z * s.normal;
    vec4 d = look_up_matrix * vec4(reflect(point.ray, h), 1.0);
    light += tap.weight * incomingLight(point.position, normalize(d.xyz), sqrt(tap.alpha), footprint);
    weight += tap.weight;
  }
  return weight > 0.0 ? light / weight : vec3(0.0);
}

#include "suns_on_one_lobe.glsl"
