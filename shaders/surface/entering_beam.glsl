// The beam of a ray that goes into a body, for the parts "transmission" that follow it on.
#include "beam.glsl"

// Beam::pixel of a direction that changes from pixel to pixel: its angle is below 0 where the rays come together.
vec2 pixelOnSurface(vec3 direction, vec3 place) {
  vec3 across = dFdx(direction);
  vec3 down = dFdy(direction);
  float comes_apart = dot(across, dFdx(place)) + dot(down, dFdy(place));
  float angle = sqrt(sampleFootprint(across, down, samples_per_pixel));
  float side = sqrt(abs(dot(cross(dFdx(place), dFdy(place)), direction)) / samples_per_pixel);
  return vec2(comes_apart < 0.0 ? -angle : angle, side);
}

// Behind the surface that is drawn.
//
// direction  of the refracted ray
// eta        the index of the body
Beam enteringBeam(Surface s, SurfacePoint point, vec3 direction, float eta) {
  float cosine = clamp(-dot(point.ray, s.normal), 0.0, 1.0);
  float alpha = alphaFromPerceptualRoughness(s.material.perceptual_roughness);
  Beam beam = beamBeyond(Beam(vec3(0.0), vec2(0.0)), refractionOfBeam(alpha, cosine, eta, 0.0));
  beam.pixel = pixelOnSurface(direction, point.position);
  return beam;
}
