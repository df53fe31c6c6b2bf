// Random numbers that belong to places.

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
