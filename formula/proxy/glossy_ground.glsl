// A polished ground: over what the panorama shows of it lies a dielectric, which mirrors the scene. The mirror image
// takes the place of a share of what is there, so nothing is added under white light and nothing gets below 0. The
// ground's normal is +Y. Needs: ggx, optics.

const float kGroundIor = 1.5f;

// With the normal as z, as formulas of microfacets have it.
FN vec3 aboveGround(vec3 w) { return vec3(w.x, w.z, w.y); }

// A ray that the ground mirrors, by a facet that it sees. It may go down: then nothing is mirrored.
//
// alpha   0: of a perfect mirror
// u       two uniform numbers
FN vec3 mirroredByGround(vec3 d, float alpha, vec2 u) {
  vec3 v = aboveGround(-d);
  return aboveGround(alpha > 0.0f ? sampleGgx(vec2(alpha), v, u) : vec3(-v.x, -v.y, v.z));
}

// What of the light from there is mirrored, divided by the density of mirroredByGround: Fresnel's share of what other
// facets do not hide (Heitz 2018, eq. 19).
FN float shareMirroredByGround(vec3 d, vec3 mirrored, float alpha) {
  if (mirrored.y <= 0.0f || d.y >= 0.0f) return 0.0f;
  vec3 v = aboveGround(-d);
  float fresnel = fresnelDielectric(dot(normalize(mirrored - d), -d), kGroundIor);
  if (alpha <= 0.0f) return fresnel;
  return fresnel * ggxMaskingShadowing(vec2(alpha), v, aboveGround(mirrored)) / ggxMasking(vec2(alpha), v);
}

// The solid angle that each of so many rays of mirroredByGround stands for.
FN float solidAngleMirroredByGround(vec3 d, vec3 mirrored, float alpha, float rays) {
  if (alpha <= 0.0f) return 0.0f;
  return 1.0f / max(rays * pdfGgx(vec2(alpha), aboveGround(-d), aboveGround(mirrored)), 1e-6f);
}

// Steps in which a ray is followed through the picture, and then halves of the one in which it is behind something.
const int kMirrorSteps = 8;
const int kMirrorHalves = 4;

// Whether a place of the picture, as texel and depth, is behind what it shows.
FN bool isBehindPicture(MAP_SAMPLER depths, vec3 place) {
  ivec2 texel = clamp(ivec2(floor(vec2(place.x, place.y))), ivec2(0), mapSize(depths, 0) - 1);
  return fetchMap(depths, texel, 0).x < place.z;
}

// Where a ray that leaves the ground meets what a picture shows, which the camera's mirror image has drawn from below
// the ground: that camera sees the ray of a perfect mirror as a point, and one of a rough mirror as a short way, on
// which this looks for the first depth that is nearer to the camera than the ray's (as screen-space reflections do:
// Sousa, Kasyan & Schulz 2011, "Secrets of CryENGINE 3 graphics technology"; here the picture holds all that is seen).
//
// depths    of the picture, 0 to 1
// from, to  the ray's ends, each as texel and depth of the picture
// returns   the texel, and how far it is from `from` to `to`, as the picture shows it; below 0: nothing is met
FN vec3 hitInMirrorPicture(MAP_SAMPLER depths, vec3 from, vec3 to) {
  float behind = 2.0f;
  float before = 0.0f;
  for (int i = 1; i <= kMirrorSteps && behind > 1.0f; ++i) {
    float way = float(i) / float(kMirrorSteps);
    if (isBehindPicture(depths, mix(from, to, way)))
      behind = way;
    else
      before = way;
  }
  if (behind > 1.0f) return vec3(0.0f, 0.0f, -1.0f);
  for (int i = 0; i < kMirrorHalves; ++i) {
    float way = 0.5f * (before + behind);
    if (isBehindPicture(depths, mix(from, to, way)))
      behind = way;
    else
      before = way;
  }
  vec3 met = mix(from, to, behind);
  return vec3(met.x, met.y, behind);
}
