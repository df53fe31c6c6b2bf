// Part "look-up": what addresses the light that a surface reflects.
//   vec3 reflectedLight(Surface s, SurfacePoint point)
// Here: the ray reflected at the fragment's normal.

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec3 d = reflect(point.ray, s.normal);
  float footprint = sampleFootprint(dFdx(d), dFdy(d), samples_per_pixel);
  return incomingLight(point.position, d, s.material.perceptual_roughness, footprint);
}
