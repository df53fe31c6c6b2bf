// The light of an environment so far away that it is the same at every origin: what the parts "arriving light" have in
// common that read it from `environment`, `prefiltered` and `irradiance` (divided by π).
#include "filter_kind.glsl"
#include "mip_mapping.glsl"
#include "tangent.glsl"
#include "blur.glsl"
#include "sampling.glsl"

vec3 incomingLight(vec3 origin, vec3 d, float perceptual_roughness, float footprint) {
  Blur blur = Blur(blur_kind, first_level, last_level, texels_per_radian, coarser);
  float minified = readsMipLevels(texture_filter) ? footprintLod(footprint, texels_per_radian) : 0.0;
  vec3 direction = environment_from_world * d;
  vec4 light = blurredLight(blur, environment, prefiltered, direction, perceptual_roughness, minified);
  return environment_intensity * light.xyz;
}

vec3 arrivingIrradiance(vec3 origin, vec3 n) {
  return environment_intensity * sampleLod(irradiance, environment_from_world * n, 0.0).xyz;
}
