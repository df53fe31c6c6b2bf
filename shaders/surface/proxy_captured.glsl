// Part "proxy" (proxy_none.glsl). Here: on all that a probe has captured from its place, with the distances of it.
// Diffuse light is that of the probe's place: it comes from everywhere, and no one place tells where it is.
#include "proxy_sight.glsl"
#include "captured_sight.glsl"

uniform samplerCube captured_nearness;

ProxySight sightFrom(vec3 origin, vec3 d) {
  return capturedSight(captured_nearness, (origin - captured_from) / nearness_unit, d);
}

vec3 originOfEye(vec3 origin, vec3 d) { return origin; }

vec3 directionOfIrradiance(vec3 origin, vec3 n) { return n; }

vec3 lightOfProxy(ProxySight sight, vec3 photographed) { return photographed; }
