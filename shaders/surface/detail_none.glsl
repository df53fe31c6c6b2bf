// Part "detail": what textures add to the normal.
//   vec3 detailedNormal(SurfacePoint point, vec3 n)      world, unit, outwards; n is the smooth one
// Here: nothing.

vec3 detailedNormal(SurfacePoint point, vec3 n) { return n; }
