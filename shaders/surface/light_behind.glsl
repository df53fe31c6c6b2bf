// The light of a ray that has left all bodies: of what it meets, or else from far away.
#include "light_from_afar.glsl"

vec3 lightBehind(vec3 origin, vec3 d, float perceptual_roughness, float footprint) {
  float way = kEndless;
  vec3 light;
  if (meetsSurface(origin, d, perceptual_roughness, false, way, light)) return light;
  return lightFromAfar(origin, d, perceptual_roughness, footprint);
}
