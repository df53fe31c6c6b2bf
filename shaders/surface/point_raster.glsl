// Part "point": where the ray from the eye meets the surface.
//   SurfacePoint surfacePoint()
// Here: where the triangle was drawn.

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

SurfacePoint surfacePoint() {
  vec3 ray = orthographic > 0.5 ? camera_forward : normalize(world_position - camera_position);
  return SurfacePoint(world_position, object_position, normalize(world_normal), normalize(object_normal), world_tangent,
                      texture_uv_0, texture_uv_1, vertex_color, ray);
}
