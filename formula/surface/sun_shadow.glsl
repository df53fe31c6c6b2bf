// Shadows of suns in pictures of depths.
// Needs: constants.

const float kAboveShadow = 1.5f;      // texels that a place is lifted by
const float kLeastShadowEdge = 1.0f;  // texels to both sides

// Point i of n that are spread evenly over the unit disc: on Vogel's spiral (1979, "A better way to construct the
// sunflower head").
//   turn   from 0 to 1, of the whole: other ones lie between the points
FN vec2 shadowTap(int i, int n, float turn) {
  float radius = sqrt((float(i) + 0.5f) / float(n));
  float angle = 2.39996323f * (float(i) + turn);
  return vec2(radius * cos(angle), radius * sin(angle));
}

// How the depth of a plane changes beside a place of it, at most so steeply that a texel is no hole.
//   up   the plane's normal: across, up and away from the sun
FN vec2 slopeInShadow(vec3 up) {
  const float kSteepest = 4.0f;
  vec2 slope = vec2(up.x, up.y) / min(up.z, -1e-3f);
  return -slope * min(1.0f, kSteepest / max(length(slope), 1e-6f));
}
