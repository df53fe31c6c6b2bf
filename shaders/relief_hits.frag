// What the ray of a pixel meets of the relief in a prism, exactly: the number of the prism, the place in it, and one
// more than the number of the instance.
#include "height_sampler.glsl"
#include "exact_search.glsl"
#include "prism.glsl"

uniform mat4 clip_from_world;
uniform mat4 world_from_object;
uniform float depth;
uniform float tiles;
uniform vec3 camera_position;
uniform vec3 camera_forward;
uniform float orthographic;
uniform int instance;

in vec3 world_position;
flat in int prism;

out vec4 texel;

void main() {
  ReliefPrism p = prismOf(prism, world_from_object, depth, tiles, heightMapSize());
  bool is_parallel = orthographic > 0.5;
  vec3 ray = is_parallel ? camera_forward : normalize(world_position - camera_position);
  vec3 eye = is_parallel ? world_position - camera_forward * dot(world_position - camera_position, camera_forward)
                         : camera_position;
  vec2 passed = wayThroughPrismBox(boxOfPrism(p), eye, ray);
  ReliefHit hit = hitOfPrism(heights, heightMap(), p, eye, ray, max(passed.x, 0.0), passed.y);
  if (hit.distance < 0.0) discard;
  vec4 clip = clip_from_world * vec4(eye + hit.distance * ray, 1.0);
  gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0);
  texel = vec4(float(prism), hit.coordinates.x, hit.coordinates.y, float(instance + 1));
}
