// The point that a ray meets below the triangle, where a search says.
//   float searchedDepth(ReliefRay ray, float cosine)   its depth in the relief, in [0, 1]; the ray's cosine to the normal
#include "raster_point.glsl"
#include "heights.glsl"
#include "exact_search.glsl"
#include "relief_search.glsl"

float searchedDepth(ReliefRay ray, float cosine);

vec3 relief_place;  // of the point that was found: on the map in texels, and its height

// A ray at a grazing angle goes no farther than this many depths.
const float kLeastReliefCosine = 0.01;

SurfacePoint surfacePoint() {
  SurfacePoint point = rasterPoint();
  SurfaceChange change = rasterChange();
  float depth = reliefDepth(point);
  float cosine = max(abs(dot(point.ray, point.normal)), kLeastReliefCosine);
  vec3 to_bottom = point.ray * (depth / cosine);
  vec2 texels = material.height_frequency * heightMapSize();
  vec2 place = placeOnMap(point.uv_0 * material.height_frequency, heightMapSize());
  ReliefRay ray = ReliefRay(place, texelsAlong(change, point.normal, to_bottom));
  float found = depth > 0.0 ? searchedDepth(ray, cosine) : 0.0;
  relief_place = vec3(ray.from + found * ray.run, 1.0 - found);
  point.position += found * to_bottom;
  point.uv_0 += found * ray.run / texels;
  return point;
}

SurfaceChange surfaceChange() { return rasterChange(); }

void setDepth(SurfacePoint point) {
  vec4 clip = clip_from_world * vec4(point.position, 1.0);
  gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0);
}

float lightThatArrives(SurfacePoint point, vec3 towards) {
  float cosine = dot(towards, point.normal);
  if (cosine <= 0.0) return 0.0;
  vec3 to_top = towards * (reliefDepth(point) / max(cosine, kLeastReliefCosine));
  vec2 run = texelsAlong(rasterChange(), point.normal, to_top);
  float start = max(relief_place.z, heightAt(heights, heightMap(), relief_place.xy)) + 1e-3;
  vec3 top = vec3(relief_place.xy + (1.0 - start) * run, 1.0);
  return exactSearch(heights, heightMap(), vec3(relief_place.xy, start), top) <= 1.0 ? 0.0 : 1.0;
}
