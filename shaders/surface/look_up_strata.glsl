// Part "look-up" (look_up_environment.glsl). Here: bumps hide in what a sample of a pixel sees, and no one lobe is what
// they all reflect. Strata of it, a place in each cell of a grid, have normals of their own. Each is read as if it were
// a quarter as wide as it is: what one lobe tells of it is little, and others lie beside it.
#include "grid_random.glsl"
#include "row_of_lobes.glsl"

const float kReadOfStratum = 0.25;

// A lobe that they widen less than that is read at once.
const float kFeltWidening = 1.05;

bool hidesBumps(Surface s) { return s.material.perceptual_roughness > kFeltWidening * s.own_roughness; }

// What a stratum sees of the surface without its bumps, which the strata tell of: what bumps do from pixel to pixel
// blurs nothing. An anisotropic filter reads each stratum piece by piece, as it does the patch of a lobe.
Patch patchOfStratum(SurfacePoint point) {
  vec3 smooth_d = lookUpDirection(point, point.normal);
  float size = inversesqrt(samples_per_pixel * float(kStrata));
  return Patch(vec3(0.0), size * dFdx(smooth_d), size * dFdy(smooth_d));
}

struct Stratum {
  SurfacePoint point;
  vec3 normal;
  float perceptual_roughness;
};

// Two numbers for all strata of a sample.
vec2 randomOfSample() {
  return gridRandom(ivec3(ivec2(gl_FragCoord.xy), int(sample_phase * samples_per_pixel))).xy;
}

Stratum stratumAt(Surface s, SurfacePoint point, int i, vec2 random) {
  SurfacePoint part = stratumOf(point, placeInStratum(i, random), kReadOfStratum / float(kStrataAcross));
  vec3 n = detailedNormal(part, smoothNormal(part));
  return Stratum(part, facingNormal(seesFront() ? n : -n, point.ray),
                 widenedRoughness(s.own_roughness, hiddenSlopes(part) + hiddenDetail(part)));
}

Look lookOfStratum(Surface s, SurfacePoint point, Patch area, int i, vec2 random) {
  Stratum part = stratumAt(s, point, i, random);
  return Look(lookUpDirection(part.point, part.normal), area, part.perceptual_roughness, vec3(1.0));
}

// Strata and lobes are looked up by the same lines: what an environment shows is most of the program.
vec3 reflectedLight(Surface s, SurfacePoint point) {
  bool in_strata = hidesBumps(s);
  vec3 d = lookUpDirection(point, s.normal);
  Patch of_pixel = patchOf(dFdx(d), dFdy(d));
  Patch of_stratum = patchOfStratum(point);
  vec2 random = randomOfSample();
  int looks = in_strata ? kStrata : looksOfRow(s);
  vec3 light = vec3(0.0);
  vec3 weights = vec3(0.0);
  for (int i = 0; i < looks; ++i) {
    Look look;
    if (in_strata)
      look = lookOfStratum(s, point, of_stratum, i, random);
    else
      look = lookOfRow(s, point, d, of_pixel, i);
    light += lightOfLook(point, look);
    weights += look.weight;
  }
  return light / weights;
}

vec3 reflectedSuns(Surface s, SurfacePoint point) {
  float footprint = footprintOfPatch(patchOfStratum(point));
  if (!kHasSuns || !hidesBumps(s)) return lightOfSuns(s, point);
  vec2 random = randomOfSample();
  vec3 light = vec3(0.0);
  for (int i = 0; i < kStrata; ++i) {
    Stratum part = stratumAt(s, point, i, random);
    s.normal = part.normal;
    s.material.perceptual_roughness = part.perceptual_roughness;
    light += litBySuns(s, point.ray, suns_at_point, footprint);
  }
  return light / float(kStrata);
}
