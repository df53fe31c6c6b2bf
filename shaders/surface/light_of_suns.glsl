// The light of suns, of which sunShare(sun, place, up) says how much of one is seen from a place.
#include "charlie.glsl"
#include "ggx.glsl"
#include "lamp.glsl"
#include "sampling.glsl"
#include "sun_list.glsl"
#include "lamp_shading.glsl"
#include "sun_shading.glsl"

float sun_seen[SUN_COUNT];

void meetSuns(SurfacePoint point) {
  vec3 up = seesFront() ? point.normal : -point.normal;
  for (int i = 0; i < SUN_COUNT; ++i) {
    vec3 towards = sun_rows[2 * i].xyz;
    sun_seen[i] = sunShare(i, point.position, up) * lightThatArrives(point, towards);
  }
}

vec3 lightOfSuns(Surface s, SurfacePoint point) {
  vec3 mirrored = reflect(point.ray, s.normal);
  float footprint = sampleFootprint(dFdx(mirrored), dFdy(mirrored), samples_per_pixel);
  vec3 light = vec3(0.0);
  for (int i = 0; i < SUN_COUNT; ++i) light += sun_seen[i] * shadedBySun(s, point.ray, sunAt(i), footprint);
  return light;
}

vec3 litBySuns(Surface s, vec3 place, vec3 ray) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < SUN_COUNT; ++i)
    light += sunShare(i, place, s.normal) * shadedBySun(s, ray, sunAt(i), 0.0);
  return light;
}

vec3 irradianceOfSuns(vec3 n) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < SUN_COUNT; ++i) {
    Sun sun = sunAt(i);
    light += sun.irradiance * (facingDisc(dot(n, sun.towards), sun.radius) / kPi);
  }
  return light;
}

vec3 sunsAlong(vec3 origin, vec3 d, float perceptual_roughness, float footprint) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < SUN_COUNT; ++i)
    light += sunShare(i, origin, d) * sunInLobe(sunAt(i), d, perceptual_roughness, footprint);
  return light;
}
