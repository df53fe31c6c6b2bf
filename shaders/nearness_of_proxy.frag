// How near the environment's proxy is to the camera's place, which is within it (formula/proxy/captured_sight.glsl).
#include "eye_ray.glsl"
#include "part: proxy"

uniform float unit;

out vec4 fragment;

void main() {
  ProxySight sight = sightFrom(camera_position, eyeDirection());
  // Through the hole of a mesh nothing is met, and the place is the ray's origin.
  float far = distance(sight.place, camera_position);
  fragment = vec4(far > 0.0 ? unit / far : 0.0, 0.0, 0.0, 1.0);
}
