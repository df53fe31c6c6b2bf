// The point where the triangle was drawn.
#include "surface_point.glsl"

in vec3 object_position;
in vec3 object_normal;
in vec3 world_position;
in vec3 world_normal;
in vec4 world_tangent;
in vec2 texture_uv_0;
in vec2 texture_uv_1;
in vec4 vertex_color;
in float vertex_ior_around;

SurfaceChange raster_change;  // known before any branch, where neighbours are still compared

SurfaceChange rasterChange() { return raster_change; }

float iorAroundVertices() { return vertex_ior_around; }

SurfacePoint rasterPoint() {
  raster_change = changeOf(dFdx(world_position), dFdy(world_position), dFdx(texture_uv_0), dFdy(texture_uv_0));
  vec3 ray = orthographic > 0.5 ? camera_forward : normalize(world_position - camera_position);
  return SurfacePoint(world_position, object_position, normalize(world_normal), normalize(object_normal), world_tangent,
                      texture_uv_0, texture_uv_1, vertex_color, ray, dFdx(texture_uv_0), dFdy(texture_uv_0),
                      dFdx(texture_uv_1), dFdy(texture_uv_1), dFdx(object_position), dFdy(object_position));
}
