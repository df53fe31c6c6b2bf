// Part "look-up" (look_up_reflection.glsl). Here: rays reflected at the vertices and interpolated between them, as the
// first hardware did it.

in vec3 vertex_reflection;

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec3 d = normalize(vertex_reflection);
  float footprint = sampleFootprint(dFdx(d), dFdy(d), samples_per_pixel);
  return incomingLight(point.position, d, s.material.perceptual_roughness, footprint);
}
