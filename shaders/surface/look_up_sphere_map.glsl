// Part "look-up" (look_up_reflection.glsl). Here: a sphere map's coordinates, which are those of the normal.

uniform sampler2D sphere_map;

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec4 st = sphere_map_matrix * vec4(s.normal, 1.0);
  return environment_intensity * textureLod(sphere_map, st.xy, 0.0).xyz;
}
