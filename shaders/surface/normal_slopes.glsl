// Part "normal" (normal_vertex.glsl). Here: bent by a map of slopes, without tangents.
#include "tangent.glsl"

uniform highp sampler2D slope_map;  // SlopeMoments of height_field/slope_moments.h
uniform float slope_unit;           // of them

// The mean slope that a sample of a pixel sees, and its variances.
vec4 mappedSlope(SurfacePoint point) {
  float unit = slope_unit * material.derivative_scale;
  float part = inversesqrt(samples_per_pixel);
  vec4 stored = textureGrad(slope_map, point.uv_0, part * point.uv_across, part * point.uv_down);
  return stored * vec4(unit, unit, unit * unit, unit * unit);
}

vec3 smoothNormal(SurfacePoint point) {
  SurfaceChange change = surfaceChange();
  return slopedNormal(change.along_u, change.along_v, point.normal, mappedSlope(point).xy);
}

float hiddenSlopes(SurfacePoint point) {
  vec2 variances = mappedSlope(point).zw;
  return 0.5 * (variances.x + variances.y);
}
