// The light of an environment as it is seen from where its map was captured: what the parts "arriving light" have in
// common that read it from `environment`, `prefiltered` and `irradiance` (divided by π).
#include "filter_kind.glsl"
#include "mip_mapping.glsl"
#include "tangent.glsl"
#include "blur.glsl"
#include "sampling.glsl"

vec3 arrivingLight(vec3 origin, vec3 d, float perceptual_roughness, float footprint, bool is_wide) {
  Blur blur = Blur(BLUR_KIND, first_level, last_level, texels_per_radian);
  ProxySight sight = sightFrom(origin, d);
  float seen = footprint * sight.enlargement;
  float minified = readsMipLevels(TEXTURE_FILTER) ? footprintLod(seen, texels_per_radian) : 0.0;
  vec3 direction = environment_from_world * sight.direction;
  float roughness = roughnessBeyondProxy(perceptual_roughness, sight.enlargement);
  vec4 light = is_wide ? chainLight(blur, prefiltered, direction, roughness, minified)
                       : blurredLight(blur, environment, prefiltered, direction, roughness, minified);
  return environment_intensity * lightOfProxy(sight, light.xyz);
}

vec3 incomingLight(vec3 origin, vec3 d, float perceptual_roughness, float footprint) {
  return arrivingLight(origin, d, perceptual_roughness, footprint, false);
}

vec3 lightOfLobe(vec3 origin, vec3 d, float perceptual_roughness, float footprint) {
  return arrivingLight(origin, d, perceptual_roughness, footprint, HAS_WIDE_LOBES);
}

vec3 lightOfWideLobe(vec3 origin, vec3 d, float perceptual_roughness) {
  const int kBlurPrefiltered = 0;
  return arrivingLight(origin, d, perceptual_roughness, 0.0, BLUR_KIND == kBlurPrefiltered);
}

vec3 arrivingIrradiance(vec3 origin, vec3 n) {
  vec3 direction = environment_from_world * directionOfIrradiance(origin, n);
  return environment_intensity * sampleLod(irradiance, direction, 0.0).xyz;
}
