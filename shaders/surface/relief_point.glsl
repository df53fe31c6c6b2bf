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
  vec3 up = reliefUp(point);
  float depth = dot(up, point.normal);
  float cosine = -dot(point.ray, point.normal);
  // From behind, and where there is no depth, it is the triangle.
  bool is_searched = cosine > 0.0 && depth > 0.0;
  vec3 to_bottom = point.ray * (depth / max(cosine, kLeastReliefCosine));
  vec2 texels = material.height_frequency * heightMapSize();
  vec2 place = placeOnMap(point.uv_0 * material.height_frequency, heightMapSize());
  ReliefRay ray = ReliefRay(place, texelsAlong(change, point.normal, to_bottom + up));
  float found = is_searched ? searchedDepth(ray, max(cosine, kLeastReliefCosine)) : 0.0;
  relief_place = vec3(ray.from + found * ray.run, 1.0 - found);
  point.position += found * to_bottom;
  point.uv_0 += found * ray.run / texels;
  if (is_searched) seeRelief(point, change);
  return point;
}

SurfaceChange surfaceChange() { return rasterChange(); }

void setDepth(SurfacePoint point) { setDepthOf(point.position); }

float lightThatArrives(SurfacePoint point, vec3 towards) {
  return lightOverRelief(point, surfaceChange(), relief_place, towards);
}

vec3 placeAboveRelief(SurfacePoint point, vec3 towards) { return placeOnMesh(point, relief_place.z, towards); }

bool seesFront() { return gl_FrontFacing; }
