// Part "proxy" (proxy_none.glsl). Here: on a sphere.
#include "proxy_block.glsl"
#include "proxy_shape.glsl"

ProxySight sightFrom(vec3 origin, vec3 d) {
  return sightOfProxy(hitOfSphere(proxy_center, proxy_radius, origin, d), captured_at, d);
}

vec3 originOfEye(vec3 origin, vec3 d) {
  bool is_within = withinSphere(proxy_center, proxy_radius, origin) == origin;
  return is_within ? origin : nearestToCapture(origin, d, captured_at);
}

vec3 directionOfIrradiance(vec3 origin, vec3 n) { return sightFrom(origin, n).direction; }

vec3 lightOfProxy(ProxySight sight, vec3 photographed) { return photographed; }
