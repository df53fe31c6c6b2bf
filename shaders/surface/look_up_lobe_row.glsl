// Part "look-up" (look_up_environment.glsl). Here: from a row of round lobes, which is right where the surface is seen
// at an angle.
#include "row_of_lobes.glsl"

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec3 d = lookUpDirection(point, s.normal);
  return lightOfRow(s, point, d, patchOf(dFdx(d), dFdy(d)));
}

#include "suns_on_one_lobe.glsl"
