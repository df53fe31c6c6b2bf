// Dual paraboloid maps: two pictures, each of half the directions on a disc (Heidrich & Seidel, "View-independent
// environment maps", 1998). Image 0, the front, looks along +Z, image 1, the back, along −Z; on both
//   x = dx / (1 + |dz|), y = dy / (1 + |dz|)
// has +X on the right and +Y on top, so that a direction of the rim, dz = 0, lies at the same place of both (as in
// Brabec, Annen & Seidel 2002; Heidrich & Seidel's texture matrix turns the back picture by 180°). The paraboloid
// z = ½ − ½ (x² + y²) mirrors the parallel rays of an orthographic camera that way; its normal is (x, y, 1) there.
// Positions (u, v) are in [0, 1]², v down.

// 0 the front, 1 the back.
FN int paraboloidFace(vec3 d) { return d.z >= 0.0f ? 0 : 1; }

// On a face chosen by the caller; a direction of the other half falls beside the disc.
FN vec2 paraboloidPosition(int face, vec3 d) {
  float depth = 1.0f + (face == 0 ? d.z : -d.z);
  return vec2(0.5f + 0.5f * d.x / depth, 0.5f - 0.5f * d.y / depth);
}

// With ρ² = x² + y²: (2x, 2y, ±(1 − ρ²)) / (1 + ρ²). Beside the disc it continues into the other half.
FN vec3 paraboloidDirection(int face, vec2 uv) {
  vec2 p = vec2(2.0f * uv.x - 1.0f, 1.0f - 2.0f * uv.y);
  float square = dot(p, p);
  float z = (1.0f - square) / (1.0f + square);
  return vec3(p * (2.0f / (1.0f + square)), face == 0 ? z : -z);
}
