// One face of a level of a prefiltered chain: the mean of the light under a GGX lobe around each texel's direction,
// from points of light, exactly, and from some reads of the mip levels of the rest.
#include "cube.glsl"
#include "reflection_lobe.glsl"
#include "mip_taps.glsl"

uniform samplerCube rest;
uniform sampler2D lights;         // rows: directions; radiance times solid angle
uniform sampler2D chosen;         // z: how many there are
uniform sampler2D coarse_lights;  // the same again, of a coarser level
uniform sampler2D coarse_chosen;
uniform bool coarse;  // whether those count
uniform sampler2D taps;  // in this level's row: x and y in the frame of the direction, log₂ of the footprint, weight
uniform int tap_row;
uniform int tap_count;
uniform int size;
uniform int face;
uniform float alpha;
uniform float lobe_scale;  // 1 / its integral

out vec4 fragment;

vec3 fromLights(sampler2D list, sampler2D choice, vec3 normal) {
  vec3 sum = vec3(0.0);
  int count = int(texelFetch(choice, ivec2(0), 0).z);
  for (int k = 0; k < count; ++k) {
    vec3 between = texelFetch(list, ivec2(k, 0), 0).xyz - normal;
    sum += ggxLobe(alpha, 0.25 * dot(between, between)) * texelFetch(list, ivec2(k, 1), 0).xyz;
  }
  return sum * lobe_scale;
}

vec3 fromRest(vec3 normal) {
  vec3 tangent = cubeTangent(face, normal);
  vec3 bitangent = cross(normal, tangent);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < tap_count; ++i) {
    vec4 tap = texelFetch(taps, ivec2(i, tap_row), 0);
    vec3 direction = tapDirection(tangent, bitangent, normal, tap.xy);
    sum += tap.w * sampleLod(rest, direction, lodOfFootprint(tap.z, direction)).xyz;
  }
  return sum;
}

void main() {
  vec3 normal = cubeDirection(face, gl_FragCoord.xy / float(size));
  vec3 light = fromRest(normal) + fromLights(lights, chosen, normal);
  if (coarse) light += fromLights(coarse_lights, coarse_chosen, normal);
  fragment = vec4(light, 1.0);
}
