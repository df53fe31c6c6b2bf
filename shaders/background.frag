// The environment behind everything.
#include "filter_kind.glsl"
#include "reflection_lobe.glsl"
#include "sampling.glsl"
#include "part: proxy"

in vec2 screen;

uniform samplerCube environment;
uniform mat3 environment_from_world;
uniform float environment_intensity;
uniform mat4 world_from_clip;
uniform vec3 camera_position;
uniform vec3 camera_forward;
uniform float orthographic;
uniform float texels_per_radian;
uniform float samples_per_pixel;
uniform int texture_filter;    // of filter_kind.glsl
uniform float min_level;
uniform float lobe_roughness;  // blurs by the mip levels; 0: not

out vec4 fragment;

void main() {
  vec4 near_point = world_from_clip * vec4(screen, -1.0, 1.0);
  vec4 far_point = world_from_clip * vec4(screen, 1.0, 1.0);
  vec3 ray = orthographic > 0.5 ? camera_forward : far_point.xyz / far_point.w - near_point.xyz / near_point.w;
  vec3 d = normalize(ray);
  vec3 origin = camera_position;
  if (orthographic > 0.5) origin += near_point.xyz;
  ProxySight sight = sightFrom(originOfEye(origin, d), d);
  float footprint = sampleFootprint(dFdx(d), dFdy(d), samples_per_pixel) * sight.enlargement;
  float minified = readsMipLevels(texture_filter) ? footprintLod(footprint, texels_per_radian) : 0.0;
  vec3 seen = environment_from_world * sight.direction;
  float blurred = lobe_roughness > 0.0 ? lodOfLobe(lobe_roughness, texels_per_radian, seen) : min_level;
  vec3 light = sampleLod(environment, seen, max(blurred, minified)).xyz;
  fragment = vec4(lightOfProxy(sight, light) * environment_intensity, 1.0);
}
