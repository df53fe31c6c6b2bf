// Part "proxy" (proxy_none.glsl). Here: on the sides of a box.
#include "proxy_block.glsl"
#include "proxy_shape.glsl"

ProxySight sightFrom(vec3 origin, vec3 d) {
  return sightOfProxy(hitOfBox(proxy_low, proxy_high, origin, d), captured_at, d);
}

vec3 originOfEye(vec3 origin, vec3 d) {
  return withinBox(proxy_low, proxy_high, origin) == origin ? origin : nearestToCapture(origin, d, captured_at);
}

vec3 directionOfIrradiance(vec3 origin, vec3 n) { return sightFrom(origin, n).direction; }

vec3 lightOfProxy(ProxySight sight, vec3 photographed) { return photographed; }
