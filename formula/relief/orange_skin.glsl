// The skin of an orange that one would peel. Needs: grid_random, dual, relief_noise.

// Pores between which nothing stands out, vec3(∂/∂x, ∂/∂y, value): round pits of 0.34 to 0.6 in radius, as deep as they
// are wide, with the profile −(1 − r²)³, which is level at the middle and at the rim. Points of other cells than the
// nearest four are 0.725 away, farther than the widest pore reaches.
FN vec3 poresHeight(vec2 place, int period, int layer) {
  vec3 sum = vec3(0.0f, 0.0f, 0.0f);
  for (int i = 0; i < 4; ++i) {
    vec3 pore = scatteredPoint(place, i, 2, 0.55f, period, layer);
    float radius = 0.34f + 0.26f * pore.z;
    float rest = 1.0f - dot(vec2(pore), vec2(pore)) / (radius * radius);
    if (rest > 0.0f) sum -= rest * rest * vec3(6.0f / radius * vec2(pore), radius * rest);
  }
  return sum;
}

// Some 200 pores, the widest nearly twice as wide as the narrowest, in a gently uneven ground; between and in them over
// 1100 fine ones. Greatest slope 36, mean height 0.67.
FN vec3 orangeSkinHeight(vec2 uv) {
  vec2 p = fract(uv);
  vec3 ground = 0.28f * dualOfFiner(reliefNoise(6.0f * p, 6, 0), 6.0f);
  vec3 pores = 0.8f * dualOfFiner(poresHeight(14.0f * p, 14, 1), 14.0f);
  vec3 fine_pores = 0.24f * dualOfFiner(poresHeight(34.0f * p, 34, 2), 34.0f);
  return vec3(0.0f, 0.0f, 0.76f) + ground + pores + fine_pores;
}
