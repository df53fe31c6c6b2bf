// How near the environment's proxy is to the camera's place, which is within it (formula/proxy/captured_sight.glsl).
#include "part: proxy"

in vec2 screen;

uniform mat4 world_from_clip;
uniform vec3 camera_position;
uniform float unit;

out vec4 fragment;

void main() {
  vec4 far_point = world_from_clip * vec4(screen, 1.0, 1.0);
  ProxySight sight = sightFrom(camera_position, normalize(far_point.xyz / far_point.w));
  // Through the hole of a mesh nothing is met, and the place is the ray's origin.
  float far = distance(sight.place, camera_position);
  fragment = vec4(far > 0.0 ? unit / far : 0.0, 0.0, 0.0, 1.0);
}
