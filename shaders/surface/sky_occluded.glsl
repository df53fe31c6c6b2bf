// Part "sky" (sky_open.glsl). Here: the scene hides a part of the environment, as its vertices know, and shows there
// what it reflects itself.
#include "occluded_light.glsl"

in vec4 vertex_occluded;
in vec3 vertex_interreflected;
in vec3 vertex_lit_from;
in vec3 vertex_emitted;

vec3 litByEnvironment(Surface s, SurfacePoint point, vec3 transmitted, vec3 on_cloth) {
  OccludedLight light = lightAtPoint(
      s, point, PlaceInScene(vertex_occluded, vertex_interreflected, vertex_lit_from, vertex_emitted));
  vec3 reflected = occludedReflection(light, s, reflect(point.ray, s.normal), reflectedLight(s, point));
  return shadedOccluded(light, s, reflected, transmitted, on_cloth);
}
