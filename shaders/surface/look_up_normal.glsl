// Part "look-up" (look_up_reflection.glsl). Here: the normal itself.

vec3 reflectedLight(Surface s, SurfacePoint point) {
  float footprint = sampleFootprint(dFdx(s.normal), dFdy(s.normal), samples_per_pixel);
  return incomingLight(point.position, s.normal, s.material.perceptual_roughness, footprint);
}
