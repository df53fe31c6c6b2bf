// A mesh's vertex in the world, and what the fragment needs of it.
#include "frame_block.glsl"
#include "instance_block.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv_0;
layout(location = 4) in vec2 uv_1;
layout(location = 5) in vec4 color;

out vec3 object_position;
out vec3 object_normal;
out vec3 world_position;
out vec3 world_normal;
out vec4 world_tangent;
out vec2 texture_uv_0;
out vec2 texture_uv_1;
out vec4 vertex_color;
out vec3 vertex_reflection;
flat out vec3 triangle_reflection;

void main() {
  vec4 world = world_from_object * vec4(position, 1.0);
  object_position = position;
  object_normal = normal;
  world_position = world.xyz;
  world_normal = normal_matrix * normal;
  world_tangent = vec4(mat3(world_from_object) * tangent.xyz, tangent.w);
  texture_uv_0 = uv_0;
  texture_uv_1 = uv_1;
  vertex_color = color;
  // What is interpolated is the unit vector of each corner: not the reflection of the interpolated normal.
  vec3 ray = orthographic > 0.5 ? camera_forward : normalize(world.xyz - camera_position);
  vertex_reflection = reflect(ray, normalize(world_normal));
  triangle_reflection = vertex_reflection;
  gl_Position = clip_from_world * world;
}
