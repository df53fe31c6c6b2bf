// What relief that is found at another place than the triangle's does besides.
#include "heights.glsl"
#include "exact_search.glsl"
#include "tangent.glsl"

// A ray at a grazing angle goes no farther than this many depths.
const float kLeastReliefCosine = 0.01;

void setDepthOf(vec3 world) {
  vec4 clip = clip_from_world * vec4(world, 1.0);
  gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0);
}

// How uv_0 changes to the next pixel on another plane through the point, which is not farther away than the mesh says.
//   uv     the change on the mesh
//   seen   unit, of the plane
vec2 uvOnPlane(SurfacePoint point, SurfaceChange change, vec2 uv, vec3 seen) {
  float closing = dot(seen, point.ray);
  if (closing > -1e-3) return uv;
  vec3 along = uv.x * change.along_u + uv.y * change.along_v;
  vec2 own = uvAlong(change, point.normal, along - point.ray * (dot(seen, along) / closing));
  return dot(own, own) < dot(uv, uv) ? own : uv;
}

// A place that faces the eye more than the mesh does covers more of a pixel, and hides what lies behind it. So a pixel
// sees less of the texture than it would on the mesh; of the side of a steep stone, seen from low, much less.
// The slope is the mean over what is as wide as the pixel.
void seeRelief(inout SurfacePoint point, SurfaceChange change) {
  vec3 across = point.uv_across.x * change.along_u + point.uv_across.y * change.along_v;
  vec3 down = point.uv_down.x * change.along_u + point.uv_down.y * change.along_v;
  float width = max(length(cross(across, point.ray)), length(cross(down, point.ray)));
  SurfacePoint narrow = point;
  narrow.uv_across = vec2(width / max(length(change.along_u), 1e-20), 0.0);
  narrow.uv_down = vec2(0.0, width / max(length(change.along_v), 1e-20));
  vec3 seen = liftedNormal(change.along_u, change.along_v, point.normal, reliefUp(point), seenSlope(narrow).xy);
  point.uv_across = uvOnPlane(point, change, point.uv_across, seen);
  point.uv_down = uvOnPlane(point, change, point.uv_down, seen);
}

// The place of the mesh by which light reaches a point of the relief, of that height.
vec3 placeOnMesh(SurfacePoint point, float height, vec3 towards) {
  float depth = (1.0 - height) * dot(reliefUp(point), point.normal);
  return point.position + towards * (depth / max(dot(towards, point.normal), kLeastReliefCosine));
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
