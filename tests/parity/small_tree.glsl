// Stands for a tree of bodies on both sides, as smooth_cube.glsl does for a cube: one node, and two triangles over the
// square |x|, |y| < 2 at z = 0 and z = shift, of bodies 0 and 1, the second with holes; and three vertices with looks.
struct SmallTree {
  float shift;  // in [-2, 2]
};

FN uvec4 wordsOf(vec3 numbers, uint last) { return uvec4(floatBitsToUint(numbers), last); }

// Octahedral coordinates.
FN float smallTreeNormal(int word) { return 0.4f + 0.05f * float(word); }

FN uvec4 fetchTriangle(int texel, int body, float z) {
  if (texel == 0) return wordsOf(vec3(-2.0f, -2.0f, z), uint(body));
  if (texel == 1) return wordsOf(vec3(2.0f, -2.0f, z), floatBitsToUint(smallTreeNormal(0)));
  if (texel == 2) return wordsOf(vec3(0.0f, 2.0f, z), floatBitsToUint(smallTreeNormal(1)));
  return floatBitsToUint(vec4(smallTreeNormal(2), smallTreeNormal(3), smallTreeNormal(4), smallTreeNormal(0)));
}

FN uvec4 fetchWords(SmallTree tree, int texel) {
  if (texel == 0) return uvec4(3u, 5u, 13u, 1u);
  if (texel == 1) return wordsOf(vec3(-2.0f), 23u);
  if (texel == 2) return wordsOf(vec3(4.0f), 25u);
  if (texel < 5) return uvec4(0u, 0xffff0000u, 0xffffffffu, uint(-1 - 8 * (texel - 3)));  // a leaf of one triangle
  if (texel < 9) return fetchTriangle(texel - 5, 0, 0.0f);
  if (texel < 13) return fetchTriangle(texel - 9, 1, tree.shift);
  if (texel == 23) return uvec4(0u, 0x80000001u, 2u, 0u);
  if (texel == 24) return uvec4(2u, 0u, 1u, 34u);
  if (texel == 34) return uvec4(8u, 0u, 0u, 0u);
  if (texel == 35) return uvec4(0xa5c3aa0fu, 0x0ff0c33cu, 0u, 0u);
  if (texel > 24) return uvec4(0x34003800u, 0x30003400u, 0x38003000u, 0x2c003800u) + uvec4(uint(16 * texel));
  return wordsOf(vec3(0.5f, 0.25f, 0.125f) * float(texel - 12), texel % 5 == 0 ? 5u : floatBitsToUint(1.5f));
}
