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

// The normal of a surface with the skin of an orange (perturbedNormal, Blinn 1978). The height is a function of the
// place, so any frame will do for its two slopes.
//   p, n       place and unit normal of the smooth surface, both in the object's space
//   height     of the bumps
//   frequency  pits a unit of length
FN vec3 orangeNormal(vec3 p, vec3 n, float height, float frequency) {
  vec3 p_u = anyTangent(n);
  vec3 p_v = cross(n, p_u);
  vec4 d = orangeHeight(p * frequency);
  vec3 slope = vec3(d) * (height * frequency);
  return perturbedNormal(p_u, p_v, n, dot(slope, p_u), dot(slope, p_v));
}
