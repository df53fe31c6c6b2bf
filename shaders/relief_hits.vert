// A corner of the boxes around the prisms of a mesh's relief, for the picture of what rays meet there. The boxes' backs
// are drawn, so that the eye may be in one.
#include "height_sampler.glsl"
#include "exact_search.glsl"
#include "prism.glsl"

uniform mat4 clip_from_world;
uniform mat4 world_from_object;
uniform float depth;
uniform float tiles;

out vec3 world_position;
flat out int prism;

void main() {
  prism = gl_VertexID / 8;
  int corner = gl_VertexID % 8;  // its bits are x, y, z
  PrismBox box = boxOfPrism(prismOf(prism, world_from_object, depth, tiles, heightMapSize()));
  vec3 place = mix(box.low, box.high, vec3(float(corner & 1), float((corner >> 1) & 1), float(corner >> 2)));
  world_position = box.origin + place.x * box.axis_x + place.y * box.axis_y + place.z * box.axis_z;
  gl_Position = clip_from_world * vec4(world_position, 1.0);
  // The backs may lie beyond what the camera sees of the model, and must not be cut away: what they show lies before
  // them.
  gl_Position.z = min(gl_Position.z, gl_Position.w);
}
