// Part "look-up": the light that a surface reflects, by the coordinates that address it.
//   vec3 reflectedLight(Surface s, SurfacePoint point)
//   vec3 reflectedSuns(Surface s, SurfacePoint point)   likewise, all that lightOfSuns tells, of what it looks up
// Here: the coordinates are a direction of the environment.
#include "light_of_patch.glsl"

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec3 d = lookUpDirection(point, s.normal);
  return lightOfPatch(point, d, patchOf(dFdx(d), dFdy(d)), s.material.perceptual_roughness);
}

#include "suns_on_one_lobe.glsl"
