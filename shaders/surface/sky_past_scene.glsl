// Part "sky" (sky_open.glsl). Here: the scene hides a part of the environment, as its vertices know, and shows there
// what it reflects itself.
#include "past_scene.glsl"

in vec4 vertex_hidden;
in vec3 vertex_shown;
in vec3 vertex_lit_from;
in vec3 vertex_emitted;

vec3 litByEnvironment(Surface s, SurfacePoint point, vec3 transmitted, vec3 on_cloth) {
  LightPastScene light = lightAtPoint(
      s, point, PlaceInScene(vertex_hidden, vertex_shown, vertex_lit_from, vertex_emitted));
  vec3 reflected = reflectedPastScene(light, s, reflect(point.ray, s.normal), reflectedLight(s, point));
  return shadedPastScene(light, s, reflected, transmitted, on_cloth);
}
