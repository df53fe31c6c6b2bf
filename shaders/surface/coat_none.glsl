// Part "coat": a clear coat over all else.
//   vec3 coated(Surface s, SurfacePoint point, vec3 light)      light of the surface → with its coat
// Here: none.

vec3 coated(Surface s, SurfacePoint point, vec3 light) { return light; }
