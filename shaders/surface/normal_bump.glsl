// Part "normal" (normal_vertex.glsl). Here: bent by a height that is a function of the place (Blinn 1978).
#include "grid_random.glsl"
#include "tangent.glsl"
#include "height.glsl"

// The share of the slopes that a sample of a pixel sees.
float seenShare(SurfacePoint point) {
  float part = material.height_frequency / sqrt(samples_per_pixel);
  return orangeSlopeShare(part * point.object_across, part * point.object_down);
}

vec3 smoothNormal(SurfacePoint point) {
  vec3 bent = orangeNormal(point.object_position, point.object_normal, material.height_scale, material.height_frequency,
                           seenShare(point));
  return normalize(normal_matrix * bent);
}

float hiddenSlopes(SurfacePoint point) {
  float steepness = material.height_scale * material.height_frequency;
  float share = seenShare(point);
  return steepness * steepness * kOrangeSlopeVariance * (1.0 - share * share);
}
