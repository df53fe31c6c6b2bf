// How a surface answers to a sun.
// Needs: constants, ggx, lamp_shading, material, microfacet, shading, sun.

const float kLeastSunAlpha = 2e-5f;  // a mirror's, far narrower than any sun

// What facets reflect of a disc towards v, without Fresnel's factor, for a unit of irradiance of a surface that faces
// it: the mean over the disc of D G / (4 v.z).
// In slopes of facets the lobe is round, and the disc is about an ellipse: seen at an angle, facets turn light across
// the plane of incidence by 2 v·h times their slope only, so that the ellipse is that much longer. With
// slope = (v + l).xy / (v + l).z it is the image of the disc by the slope's derivative J: its spread is radius² J Jᵀ on
// the plane across l. ∫ D / 4 dω = (share of the slopes) (v·h) / h.z.
// Of a disc that the horizon cuts, the part above it is taken for an ellipse, as wide as the disc and as high as that.
// Of a lobe that is narrower than a sample, the edge is as wide as the sample sees.
//   l        towards the middle of the disc, in the frame of v; may lie below the horizon
//   seen     what a sample covers, across [rad]
FN float discInFacets(vec2 alpha, vec3 v, vec3 l, float radius, float seen) {
  float half_height = clamp(0.5f * (l.z + radius), 0.0f, radius);
  float flatness = half_height / radius;
  vec3 middle = normalize(vec3(l.x, l.y, max(l.z, half_height)));
  vec3 between = v + middle;
  vec3 h = normalize(between);
  float cosine = max(dot(v, h), 1e-4f);
  vec2 slope = vec2(between.x, between.y) / between.z;
  vec2 along = vec2(middle.x, middle.y) - slope * middle.z;
  vec2 rise = slope + along * middle.z;
  float cut = (1.0f - flatness * flatness) / max(1.0f - middle.z * middle.z, 1e-4f);
  // Low down slopes change so much over the disc that the derivative makes too much of it. Beside means over discs this
  // height is right to a tenth for all suns together, and to a factor of 2 for each (GrazedFacetsDoNotShineTooMuch).
  float height = sqrt(between.z * between.z + radius * half_height);
  vec2 scale = vec2(radius / height) / alpha;
  vec3 spread =
      vec3(scale.x * scale.x * max(1.0f + slope.x * slope.x - along.x * along.x - cut * rise.x * rise.x, 0.0f),
           scale.x * scale.y * (slope.x * slope.y - along.x * along.y - cut * rise.x * rise.y),
           scale.y * scale.y * max(1.0f + slope.y * slope.y - along.y * along.y - cut * rise.y * rise.y, 0.0f));
  vec2 widths = slope / alpha;
  // At grazing angles the product is too small for its rounding.
  float area = scale.x * scale.y * flatness * max(dot(between, middle), 0.0f) / between.z;
  float share = shareInEllipse(widths, spread, area);
  // The lobe's squared width among directions: the mean, or on the way from the mirror direction to the disc.
  float widths2 = dot(widths, widths);
  float distance2 = squaredDistance(vec3(-v.x, -v.y, v.z), middle);
  float width2 = widths2 > 1e-8f ? distance2 / widths2 : alpha.x * alpha.y * 4.0f * cosine * h.z * h.z * h.z;
  float span = spanAtEdge(distance2 + width2 - radius * radius, width2, radius);
  share = softenedShare(share, span, radius, seen);
  return ggxMaskingShadowing(alpha, v, middle) * cosine / (v.z * max(h.z, 1e-4f)) * share / (kPi * radius * radius);
}

// The radiance towards the viewer of a surface that a sun shines on which nothing hides.
//   s            seenAlong the ray
//   ray          unit, from the eye to the surface
//   footprint    the solid angle that a sample sees in the surface as in a mirror, in sr
FN vec3 shadedBySun(Surface s, vec3 ray, Sun sun, float footprint) {
  vec3 l = inFrame(s, sun.towards);
  float facing = facingDisc(l.z, sun.radius);
  if (facing <= 0.0f) return vec3(0.0f);
  vec3 v = eyeInFrame(s, ray);
  vec2 alpha = max(stretchedAlpha(s.material.perceptual_roughness, s.material.anisotropy), vec2(kLeastSunAlpha));
  float reflected = discInFacets(alpha, v, l, shownRadius(sun, footprint), sqrt(footprint));
  l.z = max(l.z, 1e-4f);
  return sun.irradiance * facing * litFrom(s, v, l, vec3(reflected / facing));
}
