// Height functions d(p) for bumps, given with their gradient: vec4(∇d, d).

// A number in [0, 1) for each corner of the integer grid: pcg3d (Jarzynski & Olano 2020), whole numbers only, so that
// every machine gives the same bits.
FN vec3 gridRandom(ivec3 cell) {
  uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v = v ^ (v >> 16u);
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return vec3(v >> 8u) / 16777216.0f;
}

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
