// The environment behind everything.
#include "filter_kind.glsl"
#include "reflection_lobe.glsl"
#include "sampling.glsl"
#include "eye_ray.glsl"
#include "part: proxy"

uniform samplerCube environment;
uniform mat3 environment_from_world;
uniform float environment_intensity;
uniform float texels_per_radian;
uniform float samples_per_pixel;
uniform int texture_filter;    // of filter_kind.glsl
uniform float min_level;
uniform float lobe_roughness;  // blurs by the mip levels; 0: not

out vec4 fragment;

void main() {
  vec3 d = eyeDirection();
  ProxySight sight = sightFrom(originOfEye(eyeOrigin(), d), d);
  float footprint = sampleFootprint(dFdx(d), dFdy(d), samples_per_pixel) * sight.enlargement;
  float minified = readsMipLevels(texture_filter) ? footprintLod(footprint, texels_per_radian) : 0.0;
  vec3 seen = environment_from_world * sight.direction;
  float blurred = lobe_roughness > 0.0 ? lodOfLobe(lobe_roughness, texels_per_radian, seen) : min_level;
  vec3 light = sampleLod(environment, seen, max(blurred, minified)).xyz;
  fragment = vec4(lightOfProxy(sight, light) * environment_intensity, 1.0);
}
