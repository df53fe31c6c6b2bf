// Height functions d(p) for bumps, given with their gradient: vec4(∇d, d). Needs: grid_random, tangent.

// The skin of an orange: a pit in each cell of the unit grid, at a random place, 1 deep and ½ in radius, with the
// profile −(1 − 4 r²)³. A pit ends after ½, so that only the eight nearest cells can be felt.
FN vec4 orangeHeight(vec3 p) {
  vec3 corner = floor(p - 0.5f);
  vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  for (int i = 0; i < 8; ++i) {
    ivec3 cell = ivec3(corner) + ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 to_p = p - vec3(cell) - gridRandom(cell);
    float rest = 1.0f - 4.0f * dot(to_p, to_p);
    if (rest > 0.0f) sum += vec4(24.0f * rest * rest * to_p, -rest * rest * rest);
  }
  return sum;
}

// The variance of one of the slopes of orangeHeight over all space: counted.
const float kOrangeSlopeVariance = 0.625f;

// What is left of such slopes in their mean over a footprint, as a factor that keeps the mean's variance. Of Gaussians
// of the variance b² a square of the side w leaves b² / (b² + w² / 12); 1 / (1 + 3.3 w²) is fitted to what is counted
// of the pits, within 0.03.
//   across, down   sides of the footprint, in cells
FN float orangeSlopeShare(vec3 across, vec3 down) {
  return 1.0f / sqrt((1.0f + 3.3f * dot(across, across)) * (1.0f + 3.3f * dot(down, down)));
}

// The normal of a surface with the skin of an orange (perturbedNormal, Blinn 1978). The height is a function of the
// place, so any frame will do for its two slopes.
//   p, n       place and unit normal of the smooth surface, both in the object's space
//   height     of the bumps
//   frequency  pits a unit of length
//   share      of its slopes
FN vec3 orangeNormal(vec3 p, vec3 n, float height, float frequency, float share) {
  vec3 p_u = anyTangent(n);
  vec3 p_v = cross(n, p_u);
  vec4 d = orangeHeight(p * frequency);
  vec3 slope = vec3(d) * (share * height * frequency);
  return perturbedNormal(p_u, p_v, n, dot(slope, p_u), dot(slope, p_v));
}
