// Part "normal" (normal_vertex.glsl). Here: bent by a map of heights, without tangents (Mikkelsen 2010, "Bump mapping
// unparametrized surfaces on the GPU").
#include "heights.glsl"
#include "tangent.glsl"

vec3 smoothNormal(SurfacePoint point) {
  SurfaceChange change = surfaceChange();
  return liftedNormal(change.along_u, change.along_v, point.normal, reliefUp(point), seenSlope(point).xy);
}

// Slopes a unit of length from those a unit of texture coordinate, as if these were at right angles.
float hiddenSlopes(SurfacePoint point) {
  SurfaceChange change = surfaceChange();
  float depth = dot(reliefUp(point), point.normal);
  vec2 squares = vec2(dot(change.along_u, change.along_u), dot(change.along_v, change.along_v));
  vec2 variances = depth * depth * seenSlope(point).zw / max(squares, vec2(1e-20));
  return 0.5 * (variances.x + variances.y);
}
