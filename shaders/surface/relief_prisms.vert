// A corner of the boxes around the prisms of a mesh's relief. Their backs are drawn, so that the eye may be in one.
#include "frame_block.glsl"
#include "instance_block.glsl"
#include "material_block.glsl"

#include "texture_filter.glsl"
#include "height_map.glsl"
#include "exact_search.glsl"
#include "prism.glsl"

out vec3 world_position;
flat out int prism;

void main() {
  prism = gl_VertexID / 8;
  int corner = gl_VertexID % 8;  // its bits are x, y, z
  PrismBox box = boxOfPrism(prismOf(cornerOfPrism(prism, 0), cornerOfPrism(prism, 1), cornerOfPrism(prism, 2),
                                    vec2(1.0), vec3(0.0)));
  vec3 place = mix(box.low, box.high, vec3(float(corner & 1), float((corner >> 1) & 1), float(corner >> 2)));
  world_position = box.origin + place.x * box.axis_x + place.y * box.axis_y + place.z * box.axis_z;
  gl_Position = clip_from_world * vec4(world_position, 1.0);
}
