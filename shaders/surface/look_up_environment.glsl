// Part "look-up": the light that a surface reflects, by the coordinates that address it.
//   vec3 reflectedLight(Surface s, SurfacePoint point)
// Here: the coordinates are a direction of the environment.

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec4 str = look_up_matrix * lookUpCoordinates(point, s.normal);
  vec3 d = normalize(str.xyz);
  float footprint = sampleFootprint(dFdx(d), dFdy(d), samples_per_pixel);
  return incomingLight(point.position, d, s.material.perceptual_roughness, footprint);
}
