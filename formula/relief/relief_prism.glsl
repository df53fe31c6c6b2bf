// Relief on a mesh: below each triangle stands a prism, whose edges go down along the normals of the corners, and which
// the relief fills. Its places are (x, y) between the corners and the height h: 1 at the triangle, 0 at the bottom,
//   place = a + x (b − a) + y (c − a) + (h − 1) n(x, y),   n(x, y) = n_a + x (n_b − n_a) + y (n_c − n_a).
// Prisms of a smooth mesh touch without gaps (Hirche et al. 2004, "Hardware accelerated per-pixel displacement mapping").
// Needs: height_map, exact_search, texture_filter.

struct ReliefPrism {
  vec3 a;
  vec3 along_x;  // b − a
  vec3 along_y;
  vec3 up;  // normal of a, times the depth of the relief
  vec3 up_along_x;
  vec3 up_along_y;
  vec2 texel;  // place of a on the height map
  vec2 texel_along_x;
  vec2 texel_along_y;
};

FN vec3 placeInPrism(ReliefPrism p, vec3 q) {
  return p.a + q.x * p.along_x + q.y * p.along_y + (q.z - 1.0f) * (p.up + q.x * p.up_along_x + q.y * p.up_along_y);
}

const int kNewtonSteps = 4;

// The coordinates (x, y, h) of a place, by Newton's method from a guess.
FN vec3 coordinatesInPrism(ReliefPrism p, vec3 place, vec3 guess) {
  vec3 q = guess;
  for (int i = 0; i < kNewtonSteps; ++i) {
    vec3 off = place - placeInPrism(p, q);
    vec3 to_x = p.along_x + (q.z - 1.0f) * p.up_along_x;
    vec3 to_y = p.along_y + (q.z - 1.0f) * p.up_along_y;
    vec3 to_h = p.up + q.x * p.up_along_x + q.y * p.up_along_y;
    vec3 x_y = cross(to_x, to_y);
    float volume = dot(x_y, to_h);
    if (abs(volume) < 1e-30f) return q;
    // Cramer's rule.
    q += vec3(dot(cross(off, to_y), to_h), dot(cross(to_x, off), to_h), dot(x_y, off)) / volume;
  }
  return q;
}

// Keeps the shares of a straight way at which a number that changes evenly along it is at least 0.
FN vec2 clippedShares(vec2 shares, float first, float last) {
  if (first < 0.0f && last < 0.0f) return vec2(1.0f, 0.0f);
  if (first >= 0.0f && last >= 0.0f) return shares;
  float at = first / (first - last);
  return first < 0.0f ? vec2(max(shares.x, at), shares.y) : vec2(shares.x, min(shares.y, at));
}

// The shares of a way in a prism's coordinates that lie in the prism; the first is greater than the second: none.
FN vec2 sharesInPrism(vec3 from, vec3 to) {
  vec2 shares = vec2(0.0f, 1.0f);
  shares = clippedShares(shares, from.x, to.x);
  shares = clippedShares(shares, from.y, to.y);
  shares = clippedShares(shares, 1.0f - from.x - from.y, 1.0f - to.x - to.y);
  shares = clippedShares(shares, from.z, to.z);
  return clippedShares(shares, 1.0f - from.z, 1.0f - to.z);
}

FN vec3 onHeightMap(ReliefPrism p, vec3 q) {
  vec2 texel = p.texel + q.x * p.texel_along_x + q.y * p.texel_along_y;
  return vec3(texel.x, texel.y, q.z);
}

struct ReliefHit {
  float distance;    // along the ray; below 0: nothing is met
  vec3 coordinates;  // in the prism
};

// Where a ray meets the relief of a prism. Seen in the prism's coordinates a straight ray is bent where the normals of
// the corners differ; it is taken as so many straight pieces.
//   nearest, farthest   between which it may pass the prism
FN ReliefHit hitOfPrism(MAP_SAMPLER heights, HeightMap map, ReliefPrism p, vec3 origin, vec3 direction, float nearest,
                        float farthest, int pieces) {
  vec3 last = coordinatesInPrism(p, origin + nearest * direction, vec3(0.33f, 0.33f, 0.5f));
  float last_distance = nearest;
  for (int i = 1; i <= pieces; ++i) {
    float distance = mix(nearest, farthest, float(i) / float(pieces));
    vec3 next = coordinatesInPrism(p, origin + distance * direction, last);
    vec2 shares = sharesInPrism(last, next);
    if (shares.x < shares.y) {
      float hit = exactSearch(heights, map, onHeightMap(p, mix(last, next, shares.x)),
                              onHeightMap(p, mix(last, next, shares.y)));
      if (hit <= 1.0f) {
        float share = mix(shares.x, shares.y, hit);
        return ReliefHit(mix(last_distance, distance, share), mix(last, next, share));
      }
    }
    last = next;
    last_distance = distance;
  }
  return ReliefHit(-1.0f, vec3(0.0f));
}
