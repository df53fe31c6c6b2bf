// Part "detail": what textures add to the normal.
//   vec3 detailedNormal(SurfacePoint point, vec3 n)      world, unit, outwards; n is the smooth one
//   float hiddenDetail(SurfacePoint point)               the variance of its slopes that a pixel averages away
// Here: nothing.

vec3 detailedNormal(SurfacePoint point, vec3 n) { return n; }

float hiddenDetail(SurfacePoint point) { return 0.0; }
