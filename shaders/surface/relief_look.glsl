// What relief that is found at another place than the triangle's does besides.
#include "heights.glsl"
#include "exact_search.glsl"

// A ray at a grazing angle goes no farther than this many depths.
const float kLeastReliefCosine = 0.01;

void setDepthOf(vec3 world) {
  vec4 clip = clip_from_world * vec4(world, 1.0);
  gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0);
}

// 1 where nothing of the relief is between a point of it and a far lamp, else 0.
//   place     of the point: on the map in texels, and its height
//   towards   unit, to the lamp
float lightOverRelief(SurfacePoint point, SurfaceChange change, vec3 place, vec3 towards) {
  float cosine = dot(towards, point.normal);
  if (cosine <= 0.0) return 0.0;
  float start = max(place.z, heightAt(heights, heightMap(), place.xy)) + 1e-3;
  if (start >= 1.0) return 1.0;
  vec3 up = reliefUp(point);
  vec3 to_top = towards * (dot(up, point.normal) / max(cosine, kLeastReliefCosine));
  vec2 run = texelsAlong(change, point.normal, to_top - up);
  vec3 top = vec3(place.xy + (1.0 - start) * run, 1.0);
  return exactSearch(heights, heightMap(), vec3(place.xy, start), top, false) <= 1.0 ? 0.0 : 1.0;
}
