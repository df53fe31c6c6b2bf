// The point that a ray meets below the triangle, where a search says.
//   float searchedDepth(ReliefRay ray, float cosine)   its depth in the relief, in [0, 1]; cosine to the normal
#include "raster_point.glsl"
#include "relief_look.glsl"
#include "relief_search.glsl"

float searchedDepth(ReliefRay ray, float cosine);

vec3 relief_place;  // of the point that was found: on the map in texels, and its height

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

void setDepth(SurfacePoint point) { setDepthOf(point.position); }

float lightThatArrives(SurfacePoint point, vec3 towards) {
  return lightOverRelief(point, surfaceChange(), relief_place, towards);
}

bool seesFront() { return gl_FrontFacing; }
