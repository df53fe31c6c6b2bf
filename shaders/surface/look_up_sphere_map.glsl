// Part "look-up" (look_up_environment.glsl). Here: they are a place of a sphere map.

uniform sampler2D sphere_map;

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec4 st = look_up_matrix * lookUpCoordinates(point, s.normal);
  return environment_intensity * textureLod(sphere_map, st.xy / st.w, 0.0).xyz;
}

#include "suns_on_one_lobe.glsl"
