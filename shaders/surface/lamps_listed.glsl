// Part "lamps" (lamps_none.glsl). Here: those of a list, Phong's point lights and a model's own. Only the relief of the
// surface blocks them.
#include "charlie.glsl"
#include "lamp.glsl"
#include "ggx.glsl"
#include "lamp_shading.glsl"

const int kRowsOfLamp = 4;

// Of each: its place and kind; the way of its light and its range; its colour; the cosines of its cone.
uniform vec4 lamp_rows[kRowsOfLamp * LAMP_COUNT];

Lamp lampAt(int index) {
  int row = kRowsOfLamp * index;
  return Lamp(int(lamp_rows[row].w), lamp_rows[row].xyz, lamp_rows[row + 1].xyz, lamp_rows[row + 2].xyz,
              lamp_rows[row + 1].w, lamp_rows[row + 3].x, lamp_rows[row + 3].y);
}

vec3 lightOfLamps(Surface s, SurfacePoint point) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < LAMP_COUNT; ++i) {
    Lamp lamp = lampAt(i);
    light += shadedByLamp(s, point.ray, point.position, lamp) *
             lightThatArrives(point, towardsLamp(lamp, point.position));
  }
  return light;
}
