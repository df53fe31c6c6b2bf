// Part "proxy" (proxy_none.glsl). Here: on the triangles of a model.
#include "proxy_block.glsl"
#include "constants.glsl"
#include "octahedral.glsl"
#include "optics.glsl"
#include "triangle_tree.glsl"
#include "proxy_mesh.glsl"

uniform highp usampler2D proxy_mesh;

ProxySight sightFrom(vec3 origin, vec3 d) { return sightOfProxy(hitOfMesh(proxy_mesh, origin, d), captured_at, d); }

vec3 originOfEye(vec3 origin, vec3 d) { return origin; }

vec3 directionOfIrradiance(vec3 origin, vec3 n) { return sightFrom(origin, n).direction; }

vec3 lightOfProxy(ProxySight sight, vec3 photographed) { return photographed; }
