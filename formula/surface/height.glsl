// Height functions d(p) for bumps, given with their gradient: vec4(∇d, d). Needs: grid_random.

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
