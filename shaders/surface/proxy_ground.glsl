// Part "proxy" (proxy_none.glsl). Here: on a level ground below a dome, on which the scene's shadow falls.
#include "proxy_block.glsl"
#include "proxy_shape.glsl"

uniform highp sampler2D ground_shadow;  // the share of light that is missing (render/light/ground_shadow.h)

ProxySight sightFrom(vec3 origin, vec3 d) {
  return sightOfProxy(hitOfGround(captured_at, proxy_radius, proxy_ground, origin, d), captured_at, d);
}

vec3 originOfEye(vec3 origin, vec3 d) {
  bool is_within = withinDome(captured_at, proxy_radius, proxy_ground, origin) == origin;
  return is_within ? origin : nearestToCapture(origin, d, captured_at);
}

vec3 directionOfIrradiance(vec3 origin, vec3 n) { return sightFrom(origin, n).direction; }

vec3 lightOfProxy(ProxySight sight, vec3 photographed) {
  vec2 from_middle = (sight.place.xz - shadow_area.xy) / shadow_area.z;
  if (!sight.is_ground || max(abs(from_middle.x), abs(from_middle.y)) >= 1.0) return photographed;
  // Towards its edge the picture of the shadow fades.
  float inside = clamp(4.0 * (1.0 - length(from_middle)), 0.0, 1.0);
  vec3 missing = inside * textureLod(ground_shadow, 0.5 + 0.5 * from_middle, 0.0).xyz;
  return shadowedGround(photographed, ground_irradiance, missing);
}
