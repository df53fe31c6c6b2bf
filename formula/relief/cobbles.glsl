// A street of cobbles. Needs: grid_random, dual, relief_noise.

// 64 rounded stones of different heights in a bed of sand. Greatest slope 82, at the stones' feet; mean height 0.42.
//
// A stone lies around each of the scattered points, within its Voronoi cell. At the distance d from the edge towards
// another point, (1 − d / reach)² is taken off a dome of height 1, so that it is at most 0 at every edge and rounds the
// cell's corners off, and has no crease. A neighbour's part fades out before scatteredPoint loses sight of it.
FN vec3 cobblesHeight(vec2 uv) {
  const int kStones = 8;
  const float kReach = 0.42f;
  vec2 p = fract(uv);
  vec3 points[9];
  int nearest = 0;
  for (int i = 0; i < 9; ++i) {
    points[i] = scatteredPoint(float(kStones) * p, i, 3, 0.5f, kStones, 0);
    if (dot(vec2(points[i]), vec2(points[i])) < dot(vec2(points[nearest]), vec2(points[nearest]))) nearest = i;
  }
  vec2 own = vec2(points[nearest]);
  vec3 dome = vec3(0.0f, 0.0f, 1.0f);
  for (int i = 0; i < 9; ++i) {
    if (i == nearest) continue;
    vec2 other = vec2(points[i]);
    vec2 across = normalize(other - own);
    // The edge is the bisector of both points.
    float t = max(1.0f - dot(0.5f * (own + other), across) / kReach, 0.0f);
    vec3 in_sight = dualSmoothstep(1.56f, 0.8f, vec3(-2.0f * other, dot(other, other)));
    dome -= dualProduct(in_sight, vec3(2.0f * t / kReach * across, t * t));
  }
  vec3 dents = dualOfFiner(reliefNoise(24.0f * p, 24, 1), 24.0f);
  vec3 grain = dualOfFiner(reliefNoise(72.0f * p, 72, 2), 72.0f);
  dome = dualOfFiner(dome, float(kStones)) + 0.12f * dents;

  vec3 stone = vec3(0.0f, 0.0f, 0.2f) + (0.48f + 0.24f * points[nearest].z) * dome + 0.02f * grain + 0.07f * dents;
  vec3 sand = vec3(0.0f, 0.0f, 0.12f) + 0.1f * grain + 0.1f * dents;
  return sand + dualProduct(dualSmoothstep(0.09f, 0.5f, dome), stone - sand);
}
