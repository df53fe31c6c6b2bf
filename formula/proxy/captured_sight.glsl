// A cube map of a scene with the distances of what it shows: a ray from beside the place of the capture is followed
// until it is as far away as what was captured in that direction (Szirmay-Kalos, Aszódi, Lazányi & Premecz 2005,
// "Approximate ray-tracing on the GPU with distance impostors"). What is hidden from that place is not known.
// Needs: proxy_sight.

const int kSightSteps = 16;
const int kSightRefinements = 6;

// The cube holds nearness, 1 / distance in a unit of length of its own: 0 where nothing is, and linear between the
// texels of a plane.
//
// The ray from + t d is divided by the share s of t = |from| s / (1 − s), so that the direction from the capture's
// place turns evenly, and is at infinity for s = 1: all lengths are multiplied by 1 − s.
//
// from, to  the ray at s = 0 and at s = 1, from the place of the capture
// returns   above 0 where the place is behind what was captured; at s = 1 never below
FN float behindCaptured(CUBE_SAMPLER nearness, vec3 from, vec3 to, float share) {
  vec3 place = mix(from, to, share);
  return length(place) * sampleLod(nearness, place, 0.0f).x - (1.0f - share);
}

// Even steps find the first that is behind; false position then brings it nearer.
FN float shareOfHit(CUBE_SAMPLER nearness, vec3 from, vec3 to) {
  float before = 0.0f;
  float behind = 1.0f;
  float at_before = behindCaptured(nearness, from, to, 0.0f);
  float at_behind = 0.0f;
  for (int i = 1; i <= kSightSteps; ++i) {
    float share = float(i) / float(kSightSteps);
    float at = behindCaptured(nearness, from, to, share);
    if (at >= 0.0f) {
      behind = share;
      at_behind = at;
      break;
    }
    before = share;
    at_before = at;
  }
  for (int i = 0; i < kSightRefinements; ++i) {
    float gap = at_behind - at_before;
    if (gap <= 0.0f) break;
    float share = mix(before, behind, clamp(-at_before / gap, 0.2f, 0.8f));
    float at = behindCaptured(nearness, from, to, share);
    if (at >= 0.0f) {
      behind = share;
      at_behind = at;
    } else {
      before = share;
      at_before = at;
    }
  }
  return behind;
}

// What it sees from there. How the surface stands that is met is not known: as if it faced both places alike, its solid
// angle is that of its distances.
//
// from     the ray's origin, from the place of the capture, in the cube's unit
// returns  its place is of no use
FN ProxySight capturedSight(CUBE_SAMPLER nearness, vec3 from, vec3 d) {
  float beside = length(from);
  if (beside <= 0.0f) return MAKE(ProxySight)(d, 1.0f, from, false);
  vec3 to = beside * d;
  float share = shareOfHit(nearness, from, to);
  vec3 seen = mix(from, to, share);
  float way = share * beside;
  return MAKE(ProxySight)(normalize(seen), way * way / dot(seen, seen), seen, false);
}
