// Part "normal": the normal of the surface without its normal map.
//   vec3 smoothNormal(SurfacePoint point)      world, unit, outwards
// Here: the vertices'.

vec3 smoothNormal(SurfacePoint point) { return point.normal; }
