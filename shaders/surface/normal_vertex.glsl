// Part "normal": the normal of the surface without its normal map.
//   vec3 smoothNormal(SurfacePoint point)      world, unit, outwards
//   float hiddenSlopes(SurfacePoint point)     the variance of slopes that a pixel averages away
// Here: the vertices'.

vec3 smoothNormal(SurfacePoint point) { return point.normal; }

float hiddenSlopes(SurfacePoint point) { return 0.0; }
