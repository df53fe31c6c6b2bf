// How a surface answers to a sun.
// Needs: constants, ggx, lamp_shading, material, microfacet, shading, sun.

const float kLeastSunAlpha = 2e-5f;  // a mirror's, far narrower than any sun

// What facets reflect of a disc towards v, without Fresnel's factor, for a unit of irradiance of a surface that faces
// it: the mean over the disc of D G / (4 v.z).
// In slopes of facets the lobe is round (shareInDisc), and the disc about an ellipse of area A = Ω / (4 (v·h) h.z³):
// ∫ D / 4 dω = (share of the slopes) (v·h) / h.z. Of a wide lobe that share is its density times A. Of a narrow one it
// is 1 where the mirror direction lies in the disc; so the two distances are compared on the way from there to the
// disc's middle.
//   l        towards the middle of the disc, in the frame of v
//   seen     what a sample covers, across [rad]
FN float discInFacets(vec2 alpha, vec3 v, vec3 l, float radius, float seen) {
  vec3 h = normalize(v + l);
  float cosine = max(dot(v, h), 1e-4f);
  vec2 slopes = vec2(h.x, h.y) / (max(h.z, 1e-4f) * alpha);
  float widths2 = dot(slopes, slopes);
  float distance2 = squaredDistance(vec3(-v.x, -v.y, v.z), l);
  // The lobe's squared width among directions: the mean, and along that way.
  float mean2 = alpha.x * alpha.y * 4.0f * cosine * h.z * h.z * h.z;
  float along2 = widths2 > 1e-8f ? distance2 / widths2 : mean2;
  float share = shareInDisc(distance2, radius, sqrt(along2), seen);
  float disc2 = radius * radius;
  share *= mix(along2 / max(mean2, 1e-20f), 1.0f, disc2 / (disc2 + mean2));
  return ggxMaskingShadowing(alpha, v, l) * cosine / (v.z * max(h.z, 1e-4f)) * share / (kPi * disc2);
}

// The radiance towards the viewer of a surface that a sun shines on which nothing hides.
//   s            seenAlong the ray
//   ray          unit, from the eye to the surface
//   footprint    the solid angle that a sample sees in the surface as in a mirror, in sr
FN vec3 shadedBySun(Surface s, vec3 ray, Sun sun, float footprint) {
  vec3 l = inFrame(s, sun.towards);
  float facing = facingDisc(l.z, sun.radius);
  if (facing <= 0.0f) return vec3(0.0f);
  l.z = max(l.z, 1e-4f);
  vec3 v = eyeInFrame(s, ray);
  vec2 alpha = max(stretchedAlpha(s.material.perceptual_roughness, s.material.anisotropy), vec2(kLeastSunAlpha));
  float reflected = discInFacets(alpha, v, l, shownRadius(sun, footprint), sqrt(footprint));
  return sun.irradiance * facing * litFrom(s, v, l, vec3(reflected / facing));
}
