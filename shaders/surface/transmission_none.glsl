// Part "transmission": what is seen through the surface.
//   vec3 transmittedLight(Surface s, SurfacePoint point)
//   float iorAround()                                    of the body that the surface lies in; 1: it lies in air
// Here: nothing.
#include "lies_in_air.glsl"

vec3 transmittedLight(Surface s, SurfacePoint point) { return vec3(0.0); }
