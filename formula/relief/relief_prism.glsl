// Relief on a mesh: below each triangle stands a prism, whose edges go down along the normals of the corners, and which
// the relief fills. Its places are (x, y) between the corners and the height h: 1 at the triangle, 0 at the bottom,
//   place = a + x (b − a) + y (c − a) + (h − 1) n(x, y),   n(x, y) = n_a + x (n_b − n_a) + y (n_c − n_a).
// Prisms of a smooth mesh touch without gaps (Hirche et al. 2004, "Hardware accelerated per-pixel displacement
// mapping").
// Needs: box, height_map, exact_search.

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
  vec3 joined;  // 1 where another prism goes on beyond the side x = 0, y = 0, x + y = 1; 0: there the relief ends
  vec2 heights;  // between which its surface lies, within [0, 1]
};

FN vec3 placeInPrism(ReliefPrism p, vec3 q) {
  return p.a + q.x * p.along_x + q.y * p.along_y + (q.z - 1.0f) * (p.up + q.x * p.up_along_x + q.y * p.up_along_y);
}

const int kNewtonSteps = 5;

// The coordinates (x, y, h) of a place, by Newton's method from a guess.
FN vec3 coordinatesInPrism(ReliefPrism p, vec3 place, vec3 guess) {
  vec3 q = guess;
  for (int i = 0; i < kNewtonSteps; ++i) {
    vec3 off = place - placeInPrism(p, q);
    if (dot(off, off) <= 1e-12f * dot(p.up, p.up)) return q;
    vec3 to_x = p.along_x + (q.z - 1.0f) * p.up_along_x;
    vec3 to_y = p.along_y + (q.z - 1.0f) * p.up_along_y;
    vec3 to_h = p.up + q.x * p.up_along_x + q.y * p.up_along_y;
    vec3 x_y = cross(to_x, to_y);
    float volume = dot(x_y, to_h);
    if (abs(volume) <= 1e-12f * length(to_x) * length(to_y) * length(to_h)) return q;
    // Cramer's rule.
    q += vec3(dot(cross(off, to_y), to_h), dot(cross(to_x, off), to_h), dot(x_y, off)) / volume;
  }
  return q;
}

// The part of a way that lies in a prism.
struct WayInPrism {
  float first;  // share of the way; greater than `last`: no part
  float last;
  bool goes_on;  // it comes from another prism
};

// By so much of themselves prisms that touch overlap, and of its height a relief goes on above its top and below its
// bottom: rays pass no gap between two prisms, and heights of exactly 1 and 0 are met.
const float kOverlap = 1e-5f;
const float kBeyond = 1e-3f;

// By so much of their distance from the world's origin, at least, places are rounded.
const float kPlaceError = 1e-6f;

// The heights between which a ray may meet something, or, having come from another prism, be taken for being above the
// surface (kJoint). On a fine mesh that is a small part of a prism.
FN vec2 slabOfPrism(ReliefPrism p) {
  float error = kPlaceError * length(p.a) / max(length(p.up), 1e-30f);
  return vec2(max(p.heights.x - kJoint - error, 0.0f), min(p.heights.y + error, 1.0f));
}

// Keeps that at which a number that changes evenly along the way is at least 0.
FN WayInPrism clippedWay(WayInPrism way, float at_start, float at_end, bool is_joined) {
  if (at_start < 0.0f && at_end < 0.0f) return MAKE(WayInPrism)(1.0f, 0.0f, false);
  if (at_start >= 0.0f && at_end >= 0.0f) return way;
  float at = at_start / (at_start - at_end);
  if (at_start >= 0.0f) return MAKE(WayInPrism)(way.first, min(way.last, at), way.goes_on);
  return at > way.first ? MAKE(WayInPrism)(at, way.last, is_joined) : way;
}

//   from, to   in the prism's coordinates
//   goes_on    whether it comes from another prism where it begins in this one
FN WayInPrism wayInPrism(ReliefPrism p, vec3 from, vec3 to, bool goes_on) {
  WayInPrism way = MAKE(WayInPrism)(0.0f, 1.0f, goes_on);
  vec3 overlap = kOverlap * p.joined;
  way = clippedWay(way, from.x + overlap.x, to.x + overlap.x, p.joined.x > 0.5f);
  way = clippedWay(way, from.y + overlap.y, to.y + overlap.y, p.joined.y > 0.5f);
  way = clippedWay(way, 1.0f + overlap.z - from.x - from.y, 1.0f + overlap.z - to.x - to.y, p.joined.z > 0.5f);
  vec2 slab = slabOfPrism(p);
  way = clippedWay(way, from.z - slab.x + kBeyond, to.z - slab.x + kBeyond, false);
  return clippedWay(way, slab.y + kBeyond - from.z, slab.y + kBeyond - to.z, false);
}

const float kMostPieces = 8.0f;

// Into how many straight pieces a ray is cut: a bottom that is larger than the top by b texels bends a ray by about
// b / 4, and n pieces leave that over n².
FN float piecesOfRay(ReliefPrism p) {
  float growth = sqrt(max(dot(p.up_along_x, p.up_along_x) / max(dot(p.along_x, p.along_x), 1e-30f),
                          dot(p.up_along_y, p.up_along_y) / max(dot(p.along_y, p.along_y), 1e-30f)));
  float texels = max(length(p.texel_along_x), length(p.texel_along_y));
  return clamp(ceil(2.0f * sqrt(growth * texels)), 1.0f, kMostPieces);
}

FN vec3 onHeightMap(ReliefPrism p, vec3 q) {
  vec2 texel = p.texel + q.x * p.texel_along_x + q.y * p.texel_along_y;
  return vec3(texel.x, texel.y, q.z);
}

struct ReliefHit {
  float distance;    // along the ray; below 0: nothing is met
  vec3 coordinates;  // in the prism
};

const int kBentSteps = 2;

// The same place on the ray itself, which is bent between the ends of a straight piece: by Newton's method.
//   change   of the coordinates, a unit of distance
FN ReliefHit onBentRay(MAP_SAMPLER heights, HeightMap map, ReliefPrism p, vec3 origin, vec3 direction, ReliefHit hit,
                       vec3 change) {
  vec2 across = change.x * p.texel_along_x + change.y * p.texel_along_y;
  for (int i = 0; i < kBentSteps; ++i) {
    vec3 q = coordinatesInPrism(p, origin + hit.distance * direction, hit.coordinates);
    vec2 texel = vec2(onHeightMap(p, q));
    vec2 first = floor(texel);
    vec4 corners = patchCorners(heights, map, first);
    float clearance = q.z - heightOfPatch(corners, texel - first);
    float closing = change.z - dot(slopeOfPatch(corners, texel - first), across);
    if (closing >= 0.0f) return hit;
    float step = -clearance / closing;
    hit = MAKE(ReliefHit)(hit.distance + step, q + step * change);
  }
  return hit;
}

// Where a ray meets the relief of a prism. Seen in the prism's coordinates a straight ray is bent where the normals of
// the corners differ; it is taken as straight pieces, and what they meet is brought onto the ray.
//   nearest, farthest   between which it may pass the prism
FN ReliefHit hitOfPrism(MAP_SAMPLER heights, HeightMap map, ReliefPrism p, vec3 origin, vec3 direction, float nearest,
                        float farthest) {
  float pieces = piecesOfRay(p);
  vec3 last = coordinatesInPrism(p, origin + nearest * direction, vec3(0.33f, 0.33f, 0.5f));
  float last_distance = nearest;
  bool goes_on = false;
  for (float piece = 1.0f; piece <= pieces; piece += 1.0f) {
    float distance = mix(nearest, farthest, piece / pieces);
    vec3 next = coordinatesInPrism(p, origin + distance * direction, last);
    WayInPrism way = wayInPrism(p, last, next, goes_on);
    if (way.first < way.last) {
      vec3 start = onHeightMap(p, mix(last, next, way.first));
      float hit = exactSearch(heights, map, start, onHeightMap(p, mix(last, next, way.last)), way.goes_on);
      if (hit <= 1.0f) {
        float share = mix(way.first, way.last, hit);
        ReliefHit met = MAKE(ReliefHit)(mix(last_distance, distance, share), mix(last, next, share));
        if (p.up_along_x == vec3(0.0f) && p.up_along_y == vec3(0.0f)) return met;
        return onBentRay(heights, map, p, origin, direction, met, (next - last) / (distance - last_distance));
      }
      // What was below the surface may still be just below it in the next piece.
      goes_on = piece < pieces && (way.goes_on || start.z >= heightAt(heights, map, vec2(start)));
    }
    last = next;
    last_distance = distance;
  }
  return MAKE(ReliefHit)(-1.0f, vec3(0.0f));
}

// A box around what a ray may meet of a prism: places are origin + x axis_x + y axis_y + z axis_z with (x, y, z) from
// low to high.
struct PrismBox {
  vec3 origin;
  vec3 axis_x;  // unit, at right angles
  vec3 axis_y;
  vec3 axis_z;
  vec3 low;
  vec3 high;
};

FN PrismBox boxOfPrism(ReliefPrism p) {
  vec2 slab = slabOfPrism(p);
  PrismBox box;
  box.origin = placeInPrism(p, vec3(0.0f, 0.0f, slab.y));
  vec3 across = cross(p.along_x, p.along_y);
  box.axis_z = dot(across, across) > 0.0f ? normalize(across) : vec3(0.0f, 0.0f, 1.0f);
  vec3 side = p.along_x - box.axis_z * dot(p.along_x, box.axis_z);
  box.axis_x = dot(side, side) > 0.0f ? normalize(side) : normalize(cross(box.axis_z, vec3(0.36f, 0.48f, 0.8f)));
  box.axis_y = cross(box.axis_z, box.axis_x);
  box.low = vec3(0.0f);
  box.high = vec3(0.0f);
  for (int i = 0; i < 6; ++i) {
    vec3 q = vec3(i % 3 == 1 ? 1.0f : 0.0f, i % 3 == 2 ? 1.0f : 0.0f, i < 3 ? slab.y : slab.x);
    vec3 place = placeInPrism(p, q) - box.origin;
    vec3 in_box = vec3(dot(place, box.axis_x), dot(place, box.axis_y), dot(place, box.axis_z));
    box.low = min(box.low, in_box);
    box.high = max(box.high, in_box);
  }
  // A place depends on each coordinate alone evenly, and so lies between the corners, but for rounding and kBeyond.
  vec3 margin = 0.01f * (box.high - box.low) + vec3(1e-3f * length(p.up)) + 1e-6f * abs(p.a);
  box.low -= margin;
  box.high += margin;
  return box;
}

// The distances along a ray between which it is in the box; the first is greater: nowhere.
FN vec2 wayThroughPrismBox(PrismBox box, vec3 origin, vec3 direction) {
  vec3 from = origin - box.origin;
  vec3 start = vec3(dot(from, box.axis_x), dot(from, box.axis_y), dot(from, box.axis_z));
  vec3 way = vec3(dot(direction, box.axis_x), dot(direction, box.axis_y), dot(direction, box.axis_z));
  return wayThroughBox(box.low, box.high, start, way);
}
