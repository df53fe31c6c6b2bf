// Part "look-up" (look_up_environment.glsl). Here: from a row of round lobes, which is right where the surface is seen
// at an angle.
#include "row_of_lobes.glsl"

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec3 d = lookUpDirection(point, s.normal);
  Patch area = patchOf(dFdx(d), dFdy(d));
  vec3 light = vec3(0.0);
  vec3 weights = vec3(0.0);
  for (int lobe = 0; lobe < looksOfRow(s); ++lobe) {
    Look look = lookOfRow(s, point, d, area, lobe);
    light += lightOfLook(point, look);
    weights += look.weight;
  }
  return light / weights;
}

#include "suns_on_one_lobe.glsl"
