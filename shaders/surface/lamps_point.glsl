// Part "lamps" (lamps_none.glsl). Here: point lights, by Phong's model.

uniform vec3 lamp_position[LAMP_COUNT];
uniform vec3 lamp_color[LAMP_COUNT];

vec3 lightOfLamps(Surface s, SurfacePoint point) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < LAMP_COUNT; ++i)
    light += shadedByPointLight(s, point.ray, normalize(lamp_position[i] - point.position), lamp_color[i]);
  return light;
}
