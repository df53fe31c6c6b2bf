// A mesh's vertex in the world, and what the fragment needs of it.
#include "frame_block.glsl"
#include "instance_block.glsl"
#include "sphere_map.glsl"
#include "texgen.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv_0;
layout(location = 4) in vec2 uv_1;
layout(location = 5) in vec4 color;
layout(location = 6) in vec4 occluded;
layout(location = 7) in vec3 interreflected;
layout(location = 8) in vec3 lit_from;
layout(location = 9) in vec3 emitted;
layout(location = 10) in float ior_around_less_one;  // so that it is 0 where it is not given

out vec3 object_position;
out vec3 object_normal;
out vec3 world_position;
out vec3 world_normal;
out vec4 world_tangent;
out vec2 texture_uv_0;
out vec2 texture_uv_1;
out vec4 vertex_color;
out vec4 vertex_occluded;
out vec3 vertex_interreflected;
out vec3 vertex_lit_from;
out vec3 vertex_emitted;
out float vertex_ior_around;
out vec4 vertex_look_up;
out vec4 vertex_picture;
flat out vec4 triangle_look_up;
flat out vec4 triangle_picture;

// Depths that were drawn before are those of this program (render/surface/depth_pass.h).
invariant gl_Position;

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
  vertex_occluded = occluded;
  vertex_interreflected = interreflected;
  vertex_lit_from = lit_from;
  vertex_emitted = emitted;
  vertex_ior_around = 1.0 + ior_around_less_one;
  // What is interpolated are the coordinates of each corner: not those of the interpolated normal.
  vec3 ray = orthographic > 0.5 ? camera_forward : normalize(world.xyz - camera_position);
  TexgenPoint corner = TexgenPoint(position, world.xyz, normalize(world_normal), ray, eye_from_world);
  vertex_look_up = LOOK_UP_COORDINATES(corner);
  vertex_picture = PICTURE_COORDINATES(corner);
  triangle_look_up = vertex_look_up;
  triangle_picture = vertex_picture;
  gl_Position = clip_from_world * world;
}
