// The point where the triangle was drawn.

in vec3 object_position;
in vec3 object_normal;
in vec3 world_position;
in vec3 world_normal;
in vec4 world_tangent;
in vec2 texture_uv_0;
in vec2 texture_uv_1;
in vec4 vertex_color;

struct SurfacePoint {
  vec3 position;         // world
  vec3 object_position;
  vec3 normal;           // world, unit, of the smooth surface
  vec3 object_normal;    // unit
  vec4 tangent;          // world, of growing u; the sign of the bitangent
  vec2 uv_0;
  vec2 uv_1;
  vec4 color;            // of the vertices
  vec3 ray;              // world, unit, from the eye
};

SurfacePoint rasterPoint() {
  vec3 ray = orthographic > 0.5 ? camera_forward : normalize(world_position - camera_position);
  return SurfacePoint(world_position, object_position, normalize(world_normal), normalize(object_normal), world_tangent,
                      texture_uv_0, texture_uv_1, vertex_color, ray);
}

// How the place changes with texture coordinates: world, a unit of uv_0.
struct SurfaceChange {
  vec3 along_u;
  vec3 along_v;
};

// Of the triangle: places and coordinates change evenly over it, so that the differences between neighbouring pixels
// tell. Without texture coordinates there is no change.
SurfaceChange rasterChange() {
  vec3 across = dFdx(world_position);
  vec3 down = dFdy(world_position);
  vec2 uv_across = dFdx(texture_uv_0);
  vec2 uv_down = dFdy(texture_uv_0);
  float area = uv_across.x * uv_down.y - uv_across.y * uv_down.x;
  if (area == 0.0) return SurfaceChange(vec3(0.0), vec3(0.0));
  return SurfaceChange((across * uv_down.y - down * uv_across.y) / area,
                       (down * uv_across.x - across * uv_down.x) / area);
}
