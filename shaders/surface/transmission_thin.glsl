// Part "transmission" (transmission_none.glsl). Here: the light from straight behind a thin sheet, blurred as a
// reflection is (KHR_materials_transmission).
#include "lies_in_air.glsl"
#include "light_behind.glsl"

vec3 transmittedLight(Surface s, SurfacePoint point) {
  return lightBehind(point.position, point.ray, s.material.perceptual_roughness, 0.0);
}
