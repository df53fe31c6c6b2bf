// Part "lamps": the light of what is near and small.
//   vec3 lightOfLamps(Surface s, SurfacePoint point)
// Here: none.

vec3 lightOfLamps(Surface s, SurfacePoint point) { return vec3(0.0); }
