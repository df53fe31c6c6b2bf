// Part "transmission": what is seen through the surface.
//   vec3 transmittedLight(Surface s, SurfacePoint point)
// Here: nothing.

vec3 transmittedLight(Surface s, SurfacePoint point) { return vec3(0.0); }
