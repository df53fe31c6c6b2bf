// What hides a sun, and holes in it (render/surface/sun_shadows.h).
uniform sampler2D base_color_map;
uniform bool has_map;
uniform vec2 alpha;  // of the material, and from where on it is solid

in vec2 texture_uv;
in float vertex_alpha;

void main() {
  float opacity = alpha.x * vertex_alpha * (has_map ? texture(base_color_map, texture_uv).w : 1.0);
  if (opacity < alpha.y) discard;
}
