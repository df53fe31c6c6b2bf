// A vertex of a mesh, for pictures of places: of back faces (formula/bodies/back_face.glsl), of how near all is.
uniform mat4 clip_from_world;
uniform mat4 world_from_object;
uniform mat3 normal_matrix;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

out vec3 world_position;
out vec3 world_normal;

// Light is drawn where these depths are.
invariant gl_Position;

void main() {
  vec4 world = world_from_object * vec4(position, 1.0);
  world_position = world.xyz;
  world_normal = normal_matrix * normal;
  gl_Position = clip_from_world * world;
}
