// Part "transmission" (transmission_none.glsl). Here: the light from where the ray goes after this one surface, for
// each kind of light its own where the glass disperses.
#include "beam.glsl"
#include "lies_in_air.glsl"
#include "light_behind.glsl"

vec3 lightThrough(Surface s, SurfacePoint point, float ior) {
  vec3 d = refractedDirection(point.ray, s.normal, ior);
  float cosine = clamp(-dot(point.ray, s.normal), 0.0, 1.0);
  float alpha = alphaFromPerceptualRoughness(s.material.perceptual_roughness);
  Beam beam = beamBeyond(Beam(vec3(0.0), vec2(0.0)), refractionOfBeam(alpha, cosine, ior, 0.0));
  float footprint = sampleFootprint(dFdx(d), dFdy(d), samples_per_pixel);
  return lightBehind(point.position, d, roughnessOfBeam(beam), footprint);
}

#include "each_kind_of_light.glsl"
