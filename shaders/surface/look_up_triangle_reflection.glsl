// Part "look-up" (look_up_reflection.glsl). Here: one reflected ray a triangle, that of its last corner: a mirror made
// of tiles, as with OpenGL's flat shading.

flat in vec3 triangle_reflection;

vec3 reflectedLight(Surface s, SurfacePoint point) {
  return incomingLight(point.position, triangle_reflection, s.material.perceptual_roughness, 0.0);
}
