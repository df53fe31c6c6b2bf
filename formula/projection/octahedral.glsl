// The sphere on a square, by way of the octahedron |x| + |y| + |z| = 1. Needs: constants.
// +Z lies at the centre, −Z at all four corners, the directions with z = 0 on the diamond |x| + |y| = 1 between them;
// +X is on the right, +Y on top, as in a mirror: seen from inside, the picture is its mirror image. Positions (u, v)
// are in [0, 1]², v down. Survey: Cigolle et al. 2014, "A survey of efficient representations for independent unit
// vectors", JCGT 3(2).

// 1 or −1, never 0: a point on an axis belongs to one side.
FN vec2 octahedralSide(vec2 p) { return vec2(p.x >= 0.0f ? 1.0f : -1.0f, p.y >= 0.0f ? 1.0f : -1.0f); }

// The point of the square [−1, 1]² that lies at p, or at the fold over the diamond's sides: (1 − |y|, 1 − |x|).
FN vec2 octahedralFolded(vec2 p) { return vec2(1.0f - abs(p.y), 1.0f - abs(p.x)) * octahedralSide(p); }

FN vec2 octahedralPosition(vec3 d) {
  vec2 p = vec2(d.x, d.y) / (abs(d.x) + abs(d.y) + abs(d.z));
  if (d.z < 0.0f) p = octahedralFolded(p);
  return vec2(0.5f + 0.5f * p.x, 0.5f - 0.5f * p.y);
}

// The point of the octahedron at a position.
FN vec3 octahedralPoint(vec2 uv) {
  vec2 p = vec2(2.0f * uv.x - 1.0f, 1.0f - 2.0f * uv.y);
  float z = 1.0f - abs(p.x) - abs(p.y);
  if (z < 0.0f) p = octahedralFolded(p);
  return vec3(p, z);
}

FN vec3 octahedralDirection(vec2 uv) { return normalize(octahedralPoint(uv)); }

// Half the octahedron, z ≥ 0, turned by 45° so that it fills the square: with p the point of the octahedron,
// u = (1 + px + py) / 2, v = (1 + px − py) / 2, so that +X is the lower right corner and +Y the upper right one.
// A direction of the other half is taken to the edge, to the direction with z = 0 below it.
FN vec2 hemioctahedralPosition(vec3 d) {
  float size = abs(d.x) + abs(d.y) + max(d.z, 0.0f);
  vec2 p = size > 0.0f ? vec2(d.x, d.y) / size : vec2(1.0f, 0.0f);
  return vec2(0.5f + 0.5f * (p.x + p.y), 0.5f + 0.5f * (p.x - p.y));
}

FN vec3 hemioctahedralDirection(vec2 uv) {
  vec2 p = vec2(uv.x + uv.y - 1.0f, uv.x - uv.y);
  return normalize(vec3(p, 1.0f - abs(p.x) - abs(p.y)));
}

// The equal-area square (Clarberg 2008, "Fast equal-area mapping of the (hemi)sphere using SIMD", JGT 13(3); that of
// pbrt-v4's infinite lights): the same topology, but every texel has the same solid angle. In a quadrant of the front
// half, at the distance r = |x| + |y| from the centre on the square stand the directions with z = 1 − r², and the
// longitude grows in proportion along the diamond: with φ = atan(dy / dx) · 2/π, (x, y) = (r − φ r, φ r).
// pbrt's axes are left-handed with +z at the centre, +x right and +y down: its (x, y, z) is our (x, −y, z).
FN vec2 equalAreaPosition(vec3 d) {
  float sine2 = d.x * d.x + d.y * d.y;
  // √(1 − |z|), in the form that keeps its digits near the centre and the corners.
  float r = sqrt(sine2 / (1.0f + abs(d.z)));
  float turned = sine2 == 0.0f ? 0.0f : r * atan(abs(d.y), abs(d.x)) * (2.0f / kPi);
  vec2 p = vec2(r - turned, turned) * octahedralSide(vec2(d.x, d.y));
  if (d.z < 0.0f) p = octahedralFolded(p);
  return vec2(0.5f + 0.5f * p.x, 0.5f - 0.5f * p.y);
}

FN vec3 equalAreaDirection(vec2 uv) {
  vec2 p = vec2(2.0f * uv.x - 1.0f, 1.0f - 2.0f * uv.y);
  bool is_front = abs(p.x) + abs(p.y) <= 1.0f;
  if (!is_front) p = octahedralFolded(p);
  float r = abs(p.x) + abs(p.y);
  if (r == 0.0f) return vec3(0.0f, 0.0f, is_front ? 1.0f : -1.0f);
  float longitude = abs(p.y) / r * (kPi / 2.0f);
  float sine = r * sqrt(max(2.0f - r * r, 0.0f));
  float z = 1.0f - r * r;
  return vec3(vec2(cos(longitude), sin(longitude)) * octahedralSide(p) * sine, is_front ? z : -z);
}
