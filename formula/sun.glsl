// A sun: a small lamp of an environment that stands apart from the map, as a disc of even radiance infinitely far away.
// Needs: constants, microfacet.

struct Sun {
  vec3 towards INITIALLY(vec3(0.0f, 1.0f, 0.0f));  // unit
  float radius INITIALLY(0.0046f);                 // of the disc, rad
  vec3 irradiance INITIALLY(vec3(0.0f));           // of a surface that faces it
};

// The squared distance of two unit directions in stereographic projection about one of them: 4 tan² of half of the
// angle, which is the angle's square where it is small. From what they differ by, since their cosine is too coarse.
FN float squaredDistance(vec3 a, vec3 b) {
  vec3 between = a - b;
  float chord2 = dot(between, between);
  return chord2 / max(1.0f - 0.25f * chord2, 1e-6f);
}

// Its radius as a sample sees it that covers a solid angle: not smaller, so that no sample misses it. Its light is the
// same then.
FN float shownRadius(Sun sun, float footprint) { return max(sun.radius, sqrt(footprint)); }

// How far squared distances are from where half of a round lobe lies in a disc, but at least as far as the lobe itself
// reaches over the disc's edge.
//   beyond   the squared distance of the two middles, plus the lobe's squared width, less the disc's squared radius
FN float spanAtEdge(float beyond, float width2, float radius) {
  return sqrt(beyond * beyond + 4.0f * width2 * radius * radius);
}

// A share of a lobe with an edge that is as wide as a sample sees: the edge of a lobe is softer by itself.
//   seen        what a sample covers, across; 0: a point
FN float softenedShare(float share, float span, float radius, float seen) {
  float edge = max(seen, 1e-6f) * radius;
  return span < edge ? 0.5f - (0.5f - share) * (span / edge) : share;
}

// The share of a round lobe that a disc beside its middle catches. The lobe is width² / (π (width² + r²)²), GGX's
// density of slopes: the stereographic picture of an even sphere, in which discs are caps, and their share is the area
// of one. With the width 0 it is 1 within the disc and 0 beyond.
//   distance2   of the two middles, squared
//   seen        what a sample covers, across; 0: a point
FN float shareInDisc(float distance2, float radius, float width, float seen) {
  float beyond = distance2 + width * width - radius * radius;
  float span = max(spanAtEdge(beyond, width * width, radius), 1e-30f);
  float share = 0.5f - 0.5f * beyond / span;
  // The same without a difference of nearly equal numbers.
  if (beyond > 0.0f) share = 2.0f * width * width * radius * radius / (span * (span + beyond));
  return softenedShare(share, span, radius, seen);
}

// The root of x (1 + distance² / (1 + x circle)) = 1, as shareInEllipse needs it for a circle.
FN float rootOfCircle(float distance2, float circle) {
  float beyond = 1.0f + distance2 - circle;
  float root = sqrt(beyond * beyond + 4.0f * circle);
  return beyond > 0.0f ? 2.0f / (beyond + root) : (root - beyond) / (2.0f * circle);
}

// The share of GGX's density of slopes that an ellipse beside its middle catches; the lobe's width is 1. The slopes are
// the gnomonic picture of a hemisphere whose density is the cosine, so that the share is the form factor of an elliptic
// cone, as of a disc in linearly transformed cosines (Heitz & Hill 2017, "Real-time line- and disk-light shading"):
// −λ n·e / √((λ₁ − λ) (λ₂ − λ)), λ the negative eigenvalue of the cone's quadratic form and e its eigenvector. With
// −λ = x and the ellipse { middle + M u, |u| ≤ 1 } of spread S = M Mᵀ, the characteristic polynomial becomes
//   x (1 + middleᵀ (1 + x S)⁻¹ middle) = 1,
// whose left side is increasing and concave: from a bound below its one root on, Newton's steps come nearer from one
// side. Both bounds are roots for circles: one is exact where the ellipse is round, the other where its middle lies on
// the line of its longer axis. Five steps leave 2e-4 at most, for axes as different as 1 to 3000; nearly always they
// leave no more than rounding does.
//   spread      S.xx, S.xy, S.yy
//   area        of the ellipse, over π: √det S, at least 0
FN float shareInEllipse(vec2 middle, vec3 spread, float area) {
  const float kLeast = 1e-18f;
  // The longer and the shorter half-axis, squared, and how far the middle lies along the longer one and beside it.
  vec2 twice = vec2(spread.x - spread.z, 2.0f * spread.y);
  float difference = length(twice);
  float longer = max(0.5f * (spread.x + spread.z + difference), kLeast);
  float shorter = area * (area / longer);
  vec2 axis = twice.x < 0.0f ? vec2(twice.y, difference - twice.x) : vec2(difference + twice.x + kLeast, twice.y);
  axis /= length(axis);
  float along2 = dot(middle, axis) * dot(middle, axis);
  float beside = middle.x * axis.y - middle.y * axis.x;
  float beside2 = beside * beside;
  float distance2 = along2 + beside2;
  float circle = min(distance2 / max(along2 / longer + beside2 / max(shorter, kLeast), kLeast), longer);
  float x = max(rootOfCircle(distance2, max(circle, kLeast)),
                rootOfCircle(along2 / (1.0f + beside2), longer / (1.0f + beside2)) / (1.0f + beside2));
  for (int i = 0; i < 5; ++i) {
    vec2 shrunk = vec2(1.0f / (1.0f + x * longer), 1.0f / (1.0f + x * shorter));
    vec2 seen = vec2(along2 * shrunk.x, beside2 * shrunk.y);
    x += (1.0f - x * (1.0f + seen.x + seen.y)) / (1.0f + dot(seen, shrunk));
  }
  vec2 shrunk = vec2(1.0f / (1.0f + x * longer), 1.0f / (1.0f + x * shorter));
  float turned2 = along2 * shrunk.x * shrunk.x + beside2 * shrunk.y * shrunk.y;
  return x * area * sqrt(shrunk.x * shrunk.y) / (1.0f + turned2);
}

// The mean cosine of reflected directions of GGX's facets about their mirror direction, seen from straight above; those
// below the surface count 0. From cos² of a facet's angle = (1 − u) / (1 − (1 − α²) u) for even u, by integration of
// 2 cos² − 1 to where it is 0.
FN float meanCosineOfLobe(float alpha) {
  float a2 = clamp(alpha * alpha, 1e-8f, 0.96f);
  float b = 1.0f - a2;
  return 2.0f * (1.0f / ((1.0f + a2) * b) + a2 / (b * b) * log(2.0f * a2 / (1.0f + a2))) - 1.0f / (1.0f + a2);
}

// What of a sun a look-up sees: as prefilteredLight does of a map, by GGX's lobe about its mirror direction.
//   d            unit, where it looks
//   footprint    the solid angle that a sample sees, in sr
FN vec3 sunInLobe(Sun sun, vec3 d, float perceptual_roughness, float footprint) {
  float alpha = alphaFromPerceptualRoughness(perceptual_roughness);
  float radius = shownRadius(sun, footprint);
  float distance2 = squaredDistance(d, sun.towards);
  // A facet turns what it reflects by twice its own angle. The projection enlarges what is far from its middle.
  float share = shareInDisc(distance2, radius * (1.0f + 0.25f * distance2), 2.0f * alpha, sqrt(footprint));
  float facing = max(dot(d, sun.towards), 0.0f) / meanCosineOfLobe(alpha);
  return sun.irradiance * (share * facing / (kPi * radius * radius));
}

// The mean of max(cosine, 0) over a disc that may be cut by the horizon.
//   cosine   of its middle with the normal
FN float facingDisc(float cosine, float radius) {
  float above = clamp(cosine + radius, 0.0f, 2.0f * radius);
  return max(cosine, above * above / (4.0f * radius));
}
