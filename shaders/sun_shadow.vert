// A vertex of a mesh in a picture of depths from a sun.
uniform mat4 clip_from_object;
uniform vec4 map_matrix;  // of base_color_map's coordinates, its two columns
uniform vec3 map_offset;  // and their set

layout(location = 0) in vec3 position;
layout(location = 3) in vec2 uv_0;
layout(location = 4) in vec2 uv_1;
layout(location = 5) in vec4 color;

out vec2 texture_uv;
out float vertex_alpha;

void main() {
  texture_uv = mat2(map_matrix.xy, map_matrix.zw) * (map_offset.z > 0.5 ? uv_1 : uv_0) + map_offset.xy;
  vertex_alpha = color.w;
  gl_Position = clip_from_object * vec4(position, 1.0);
}
