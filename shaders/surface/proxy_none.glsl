// Part "proxy": where the environment is that a ray sees.
//   ProxySight sightFrom(vec3 origin, vec3 d)                what it sees, from where the map was captured
//   vec3 originOfEye(vec3 origin, vec3 d)                    where the ray begins, if it is the eye's
//   vec3 directionOfIrradiance(vec3 origin, vec3 n)          where the irradiance is of a surface with that normal
//   vec3 lightOfProxy(ProxySight sight, vec3 photographed)   what is left of the map's light there
// All in the world's axes. Here: infinitely far away.
#include "proxy_sight.glsl"

ProxySight sightFrom(vec3 origin, vec3 d) { return ProxySight(d, 1.0, origin, false); }

vec3 originOfEye(vec3 origin, vec3 d) { return origin; }

vec3 directionOfIrradiance(vec3 origin, vec3 n) { return n; }

vec3 lightOfProxy(ProxySight sight, vec3 photographed) { return photographed; }
