// Slopes of a height field, and normals in the space of its texture: +X along growing u (to the right), +Y along
// falling v (up, since v counts from the top row), +Z out of the surface. Heights and lengths are in texture widths.

// How the slopes are taken from the 3 x 3 texels around one, in the order of HeightDifference.
const int kBackwardDifference = 0;
const int kForwardDifference = 1;
const int kCentralDifference = 2;
const int kSobelDifference = 3;

// How much a height field rises from a texel to the next, along u and along v. Backward differences are those of the
// lecture, d_ij − d_(i−1)j and d_ij − d_i(j−1). Sobel's are central differences of rows (columns) that are smoothed by
// (1, 2, 1) / 4 across (Sobel and Feldman 1968). Weights come before sums, so that huge heights do not overflow.
//   above, row, below   the heights from left to right; row.y is the texel's own
FN vec2 heightDifference(int difference, vec3 above, vec3 row, vec3 below) {
  if (difference == kBackwardDifference) return vec2(row.y - row.x, row.y - above.y);
  if (difference == kForwardDifference) return vec2(row.z - row.y, below.y - row.y);
  if (difference == kCentralDifference) return vec2(0.5f * row.z - 0.5f * row.x, 0.5f * below.y - 0.5f * above.y);
  vec3 columns = 0.125f * above + 0.25f * row + 0.125f * below;
  return vec2(columns.z - columns.x, (0.125f * below.x + 0.25f * below.y + 0.125f * below.z) -
                                         (0.125f * above.x + 0.25f * above.y + 0.125f * above.z));
}

// The slope (∂d/∂u, ∂d/∂v) of such differences. The limits keep squares of slopes finite and tilt nothing: 1e18 is a
// wall.
//   per_texel   texture widths that a height of 1 has, over those from a texel to the next
FN vec2 slopeOfDifference(vec2 difference, float per_texel) {
  return clamp(clamp(difference, -1e30f, 1e30f) * per_texel, -1e18f, 1e18f);
}

// The unit normal of a surface with that slope. p_u × p_(−v) = (1, 0, d_u) × (0, 1, −d_v) = (−d_u, d_v, 1).
FN vec3 normalFromSlope(vec2 slope) { return normalize(vec3(-slope.x, slope.y, 1.0f)); }

// And back.
//   normal   of any length, z > 0
FN vec2 slopeFromNormal(vec3 normal) { return vec2(-normal.x / normal.z, normal.y / normal.z); }
