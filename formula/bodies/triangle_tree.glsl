// The first triangle that a ray meets, found in a tree of boxes, and the bodies that triangles enclose. All is words of
// a texture, written by scene/bodies/body_tree.cpp; texel 0 says where the parts begin:
//   0              the root, the first texel of the triangles, that of the bodies, and whether some body disperses
//   1, 2           the lower corner of the box around all, and its size
//   of a node      two texels, one a child: the corners of its box, in 16 bits of the box around all; the child
//   of a triangle  four texels: its corners; the body; the octahedral normals of its corners
//   of a body      five texels, as struct Body
// A child is the texel of a node or, below 0, the triangles of a leaf.
// Needs: constants, octahedral, optics.

const int kDeepestNode = 40;         // the tree is no deeper
const int kTrianglesOfLeaf = 8;      // at most
const int kTexelsOfHead = 3;
const int kTexelsOfNode = 2;
const int kTexelsOfTriangle = 4;
const int kTexelsOfBody = 5;
const float kBeyondAll = 3e38f;      // a distance at which nothing is
// How far triangles reach over their edges, in barycentric coordinates, so that few rays slip through between two: of
// triangles as small as 1/1000 of the way, rounding is wrong by more. If they reached farther, two triangles would
// often count for one; so that is for a ray that cannot have met nothing.
const float kNarrowMargin = 1e-6f;
const float kWideMargin = 1e-2f;

struct TriangleHit {
  float distance;
  int triangle;      // −1: nothing is met
  vec2 barycentric;  // of the second and the third corner
};

// A leaf's number, and back: which triangle is its first, and how many it has.
FN int leafOf(int first, int count) { return -1 - (first * kTrianglesOfLeaf + count - 1); }
FN int firstOfLeaf(int leaf) { return (-1 - leaf) / kTrianglesOfLeaf; }
FN int countOfLeaf(int leaf) { return (-1 - leaf) % kTrianglesOfLeaf + 1; }

FN vec3 floatsOf(uvec4 words) { return uintBitsToFloat(uvec3(words.x, words.y, words.z)); }

// 1 / d, finite: 0 · ∞ would be no number.
FN float inverseOf(float d) { return abs(d) > 1e-18f ? 1.0f / d : (d < 0.0f ? -1e18f : 1e18f); }
FN vec3 inverseDirection(vec3 d) { return vec3(inverseOf(d.x), inverseOf(d.y), inverseOf(d.z)); }

// The distance at which a ray enters a child's box, if it is within it somewhere between `nearest` and `farthest`; else
// kBeyondAll. The far end is moved by the rounding of its computation (Ize 2013, "Robust BVH ray traversal").
//
// origin, inverse   in the box around all, whose corners are 0 and 1
FN float entryOfBox(uvec4 child, vec3 origin, vec3 inverse, float nearest, float farthest) {
  vec2 low_xy = unpackUnorm2x16(child.x);
  vec2 between = unpackUnorm2x16(child.y);
  vec2 high_yz = unpackUnorm2x16(child.z);
  vec3 a = (vec3(low_xy, between.x) - origin) * inverse;
  vec3 b = (vec3(between.y, high_yz) - origin) * inverse;
  vec3 enters = min(a, b);
  vec3 leaves = max(a, b);
  float first = max(max(enters.x, enters.y), max(enters.z, nearest));
  float last = min(min(leaves.x, leaves.y), min(leaves.z, farthest)) * 1.0000005f;
  return first <= last ? first : kBeyondAll;
}

// Möller & Trumbore 1997, "Fast, minimum storage ray/triangle intersection": from both sides.
//
// margin   kNarrowMargin or kWideMargin
// returns  distance, and the barycentric coordinates; kBeyondAll: it is not met
FN vec3 meetingOfTriangle(vec3 p0, vec3 p1, vec3 p2, vec3 origin, vec3 direction, float margin) {
  vec3 e1 = p1 - p0;
  vec3 e2 = p2 - p0;
  vec3 across = cross(direction, e2);
  float determinant = dot(e1, across);
  if (determinant == 0.0f) return vec3(kBeyondAll, 0.0f, 0.0f);
  vec3 from = origin - p0;
  float u = dot(from, across) / determinant;
  vec3 turned = cross(from, e1);
  float v = dot(direction, turned) / determinant;
  bool is_met = u >= -margin && v >= -margin && u + v <= 1.0f + margin;
  return vec3(is_met ? dot(e2, turned) / determinant : kBeyondAll, u, v);
}

// The nearest of a leaf's triangles, if it is nearer than `best`.
FN TriangleHit nearestOfLeaf(WORD_SAMPLER tree, int triangles, int leaf, vec3 origin, vec3 direction, float nearest,
                             int excluded, float margin, TriangleHit best) {
  TriangleHit found = best;
  int first = firstOfLeaf(leaf);
  int end = first + countOfLeaf(leaf);
  for (int triangle = first; triangle < end; ++triangle) {
    if (triangle == excluded) continue;
    int texel = triangles + triangle * kTexelsOfTriangle;
    vec3 met = meetingOfTriangle(floatsOf(fetchWords(tree, texel)), floatsOf(fetchWords(tree, texel + 1)),
                                 floatsOf(fetchWords(tree, texel + 2)), origin, direction, margin);
    if (met.x > nearest && met.x < found.distance) found = MAKE(TriangleHit)(met.x, triangle, vec2(met.y, met.z));
  }
  return found;
}

// The first triangle that a ray meets beyond `nearest`, the nearer child first.
//
// direction  unit
// excluded   a triangle that is not met: the one that the ray leaves; −1: none
// unseen     a child that is not visited, nor what is in it; 0: none
FN TriangleHit nearestTriangleBeside(WORD_SAMPLER tree, vec3 origin, vec3 direction, float nearest, int excluded,
                                     int unseen, float margin) {
  uvec4 head = fetchWords(tree, 0);
  vec3 size = floatsOf(fetchWords(tree, 2));
  vec3 inverse = inverseDirection(direction) * size;
  vec3 origin_in_all = (origin - floatsOf(fetchWords(tree, 1))) / size;
  TriangleHit best = MAKE(TriangleHit)(kBeyondAll, -1, vec2(0.0f));
  int waiting[kDeepestNode];
  int count = 0;
  int node = int(head.x);
  while (true) {
    // First down to a leaf, so that rays side by side, which a processor follows together, then test triangles together
    // (Aila & Laine 2009, "Understanding the efficiency of ray traversal on GPUs": while-while).
    while (node >= 0) {
      uvec4 child_a = fetchWords(tree, node);
      uvec4 child_b = fetchWords(tree, node + 1);
      float a = entryOfBox(child_a, origin_in_all, inverse, nearest, best.distance);
      float b = entryOfBox(child_b, origin_in_all, inverse, nearest, best.distance);
      if (int(child_a.w) == unseen) a = kBeyondAll;
      if (int(child_b.w) == unseen) b = kBeyondAll;
      node = a <= b ? int(child_a.w) : int(child_b.w);
      if (max(a, b) < kBeyondAll) waiting[count++] = a <= b ? int(child_b.w) : int(child_a.w);
      if (min(a, b) < kBeyondAll) continue;
      if (count == 0) return best;
      node = waiting[--count];
    }
    best = nearestOfLeaf(tree, int(head.y), node, origin, direction, nearest, excluded, margin, best);
    if (count == 0) return best;
    node = waiting[--count];
  }
  return best;
}

FN TriangleHit nearestTriangle(WORD_SAMPLER tree, vec3 origin, vec3 direction, float nearest, int excluded,
                               float margin) {
  return nearestTriangleBeside(tree, origin, direction, nearest, excluded, 0, margin);
}

// The surface of a body where a ray meets it.
struct BodySurface {
  vec3 normal;            // unit, outwards, interpolated
  vec3 geometric_normal;  // unit, of the triangle
  float curvature;        // the mean of its three edges': how much the normal turns over a way [1/world unit]; above 0
                          // where the body bulges
  int body;
};

FN float curvatureAlong(vec3 edge, vec3 change) { return dot(change, edge) / dot(edge, edge); }

FN BodySurface bodySurfaceAt(WORD_SAMPLER tree, TriangleHit hit) {
  int texel = int(fetchWords(tree, 0).y) + hit.triangle * kTexelsOfTriangle;
  uvec4 corner_0 = fetchWords(tree, texel);
  uvec4 corner_1 = fetchWords(tree, texel + 1);
  uvec4 corner_2 = fetchWords(tree, texel + 2);
  vec4 normals = uintBitsToFloat(fetchWords(tree, texel + 3));
  vec3 n0 = octahedralDirection(uintBitsToFloat(uvec2(corner_1.w, corner_2.w)));
  vec3 n1 = octahedralDirection(vec2(normals.x, normals.y));
  vec3 n2 = octahedralDirection(vec2(normals.z, normals.w));
  vec2 b = hit.barycentric;
  vec3 e1 = floatsOf(corner_1) - floatsOf(corner_0);
  vec3 e2 = floatsOf(corner_2) - floatsOf(corner_0);
  float curvature =
      (curvatureAlong(e1, n1 - n0) + curvatureAlong(e2, n2 - n0) + curvatureAlong(e2 - e1, n2 - n1)) / 3.0f;
  vec3 geometric_normal = normalize(cross(normalize(e1), normalize(e2)));  // however small they are
  vec3 n = n0 * (1.0f - b.x - b.y) + n1 * b.x + n2 * b.y;
  vec3 normal = dot(n, n) > 0.0f ? normalize(n) : geometric_normal;  // none where the corners' cancel out
  return MAKE(BodySurface)(normal, geometric_normal, curvature, int(corner_0.w));
}

// What fills the inside of closed triangles: the numbers of its material that light needs which passes through.
struct Body {
  vec3 base_color;
  RefractiveIndex index;
  vec3 attenuation_color;
  float attenuation_distance;
  float perceptual_roughness;
  float specular;
  int priority;
};

FN Body bodyAt(WORD_SAMPLER tree, int body) {
  int texel = int(fetchWords(tree, 0).z) + body * kTexelsOfBody;
  vec4 color = uintBitsToFloat(fetchWords(tree, texel));
  vec4 attenuation = uintBitsToFloat(fetchWords(tree, texel + 1));
  uvec4 rest = fetchWords(tree, texel + 2);
  vec3 numbers = floatsOf(rest);
  RefractiveIndex index = MAKE(RefractiveIndex)(color.w, numbers.y, uintBitsToFloat(fetchWords(tree, texel + 3)),
                                                uintBitsToFloat(fetchWords(tree, texel + 4)));
  return MAKE(Body)(vec3(color), index, vec3(attenuation), attenuation.w, numbers.x, numbers.z, int(rest.w));
}
