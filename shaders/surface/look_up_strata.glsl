// Part "look-up" (look_up_environment.glsl). Here: bumps hide in what a sample of a pixel sees, and no one lobe is what
// they all reflect. Strata of it, a place in each cell of a grid, have normals of their own. Each is read as if it were
// a quarter as wide as it is: what one lobe tells of it is little, and others lie beside it.
#include "grid_random.glsl"
#include "row_of_lobes.glsl"

const float kReadOfStratum = 0.25;

// A lobe that they widen less than that is read at once.
const float kFeltWidening = 1.05;

vec3 reflectedLight(Surface s, SurfacePoint point) {
  vec3 d = lookUpDirection(point, s.normal);
  Patch area = patchOf(dFdx(d), dFdy(d));
  // Of the surface without its bumps, of which the strata tell: what they do from pixel to pixel is no blur.
  vec3 smooth_d = lookUpDirection(point, point.normal);
  float footprint = sampleFootprint(dFdx(smooth_d), dFdy(smooth_d), samples_per_pixel * float(kStrata));
  if (s.material.perceptual_roughness <= kFeltWidening * s.own_roughness)
    return lightOfRow(s, point, d, area);
  ivec3 sample_place = ivec3(ivec2(gl_FragCoord.xy), int(sample_phase * samples_per_pixel));
  vec2 random = gridRandom(sample_place).xy;
  vec3 light = vec3(0.0);
  for (int i = 0; i < kStrata; ++i) {
    SurfacePoint part = stratumOf(point, placeInStratum(i, random), kReadOfStratum / float(kStrataAcross));
    vec3 n = detailedNormal(part, smoothNormal(part));
    n = facingNormal(seesFront() ? n : -n, point.ray);
    light += lightOfLobe(point.position, lookUpDirection(part, n),
                         widenedRoughness(s.own_roughness, hiddenSlopes(part) + hiddenDetail(part)), footprint);
  }
  return light / float(kStrata);
}
