// The light of suns, of which sunShare(sun, place, up) says how much of one is seen from a place.
#include "charlie.glsl"
#include "ggx.glsl"
#include "lamp.glsl"
#include "sampling.glsl"
#include "sun_list.glsl"
#include "lamp_shading.glsl"
#include "sun_shading.glsl"

const bool kHasSuns = true;

struct SunsSeen {
  float share[SUN_COUNT];
};

SunsSeen suns_at_point;
SunsSeen suns_on_mesh;

SunsSeen sunsSeen(vec3 place, vec3 up) {
  SunsSeen seen;
  for (int i = 0; i < SUN_COUNT; ++i) seen.share[i] = sunShare(i, place, up);
  return seen;
}

SunsSeen allSuns() {
  SunsSeen seen;
  for (int i = 0; i < SUN_COUNT; ++i) seen.share[i] = 1.0;
  return seen;
}

void meetSuns(SurfacePoint point) {
  vec3 up = seesFront() ? point.normal : -point.normal;
  for (int i = 0; i < SUN_COUNT; ++i) {
    vec3 towards = sunAt(i).towards;
    suns_on_mesh.share[i] = sunShare(i, placeAboveRelief(point, towards), up);
    suns_at_point.share[i] = suns_on_mesh.share[i] * lightThatArrives(point, towards);
  }
}

vec3 litBySuns(Surface s, vec3 ray, SunsSeen seen, float footprint) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < SUN_COUNT; ++i) light += seen.share[i] * shadedBySun(s, ray, sunAt(i), footprint);
  return light;
}

vec3 lightOfSuns(Surface s, SurfacePoint point) {
  vec3 mirrored = reflect(point.ray, s.normal);
  float footprint = sampleFootprint(dFdx(mirrored), dFdy(mirrored), samples_per_pixel);
  return litBySuns(s, point.ray, suns_at_point, footprint);
}

vec3 irradianceOfSuns(vec3 n, SunsSeen seen) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < SUN_COUNT; ++i) {
    Sun sun = sunAt(i);
    light += sun.irradiance * (seen.share[i] * facingDisc(dot(n, sun.towards), sun.radius) / kPi);
  }
  return light;
}

vec3 sunsAlong(vec3 origin, vec3 d, float perceptual_roughness, float footprint) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < SUN_COUNT; ++i)
    light += sunShare(i, origin, d) * sunInLobe(sunAt(i), d, perceptual_roughness, footprint);
  return light;
}
