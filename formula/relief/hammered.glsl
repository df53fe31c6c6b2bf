// Hammered gold. Needs: grid_random, dual, relief_noise.

// 64 blows of a round hammer, of different depths: each leaves a paraboloid, of which the lowest is seen. Where two
// meet, the ridge is rounded by −log Σ exp(−k h) / k, whose slope is the mean of theirs with the weights exp(−k h).
// Dents of cells farther away would have at most 2 · 10⁻⁴ of all weights. Greatest slope 14, mean height 0.36.
FN vec3 hammeredHeight(vec2 uv) {
  const int kDents = 8;
  const float kSharpness = 12.0f;
  vec2 p = float(kDents) * fract(uv);
  vec3 sum = vec3(0.0f, 0.0f, 0.0f);
  for (int i = 0; i < 9; ++i) {
    vec3 dent = scatteredPoint(p, i, 3, 0.7f, kDents, 0);
    float weight = exp(-kSharpness * (dot(vec2(dent), vec2(dent)) + 0.25f * dent.z));
    sum += weight * vec3(-2.0f * vec2(dent), 1.0f);
  }
  vec3 height = vec3(vec2(sum) / sum.z, -log(sum.z) / kSharpness);
  return vec3(0.0f, 0.0f, 0.03f) + 1.07f * dualOfFiner(height, float(kDents));
}
