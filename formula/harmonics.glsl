// Real spherical harmonics up to l = 2, orthonormal on the sphere (Ramamoorthi & Hanrahan 2001), numbered
// i = l (l + 1) + m. Needs: constants.

FN float harmonic(int i, vec3 d) {
  if (i == 0) return 0.282094792f;                       // √(1 / 4π)
  if (i == 1) return 0.488602512f * d.y;                 // √(3 / 4π)
  if (i == 2) return 0.488602512f * d.z;
  if (i == 3) return 0.488602512f * d.x;
  if (i == 4) return 1.092548431f * d.x * d.y;           // √(15 / 4π)
  if (i == 5) return 1.092548431f * d.y * d.z;
  if (i == 6) return 0.315391565f * (3.0f * d.z * d.z - 1.0f);  // √(5 / 16π)
  if (i == 7) return 1.092548431f * d.x * d.z;
  return 0.546274215f * (d.x * d.x - d.y * d.y);         // √(15 / 16π)
}

// What the cosine lobe leaves of band l: A0 = π, A1 = 2π/3, A2 = π/4.
FN float cosineLobeBand(int l) {
  if (l == 0) return kPi;
  if (l == 1) return kTwoPi / 3.0f;
  return kPi / 4.0f;
}

// Irradiance on a surface of normal n, from the nine coefficients of the cosine-weighted light (cosineLobeBand applied).
// Nine coefficients leave ripples around a small bright light, which may dip below 0 opposite to it: there is none.
FN vec3 harmonicIrradiance(vec3 n, vec3 c0, vec3 c1, vec3 c2, vec3 c3, vec3 c4, vec3 c5, vec3 c6, vec3 c7, vec3 c8) {
  vec3 sum = c0 * harmonic(0, n) + c1 * harmonic(1, n) + c2 * harmonic(2, n) + c3 * harmonic(3, n) +
             c4 * harmonic(4, n) + c5 * harmonic(5, n) + c6 * harmonic(6, n) + c7 * harmonic(7, n) +
             c8 * harmonic(8, n);
  return max(sum, vec3(0.0f));
}
