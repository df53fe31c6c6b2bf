// Real spherical harmonics up to l = 4, orthonormal on the sphere (Sloan 2008, "Stupid spherical harmonics tricks",
// appendix A2, with all signs positive), numbered i = l (l + 1) + m. Needs: constants.

FN float harmonicOfBand3(int i, vec3 d) {
  if (i == 9) return 0.590043589f * d.y * (3.0f * d.x * d.x - d.y * d.y);    // √(35 / 32π)
  if (i == 10) return 2.890611443f * d.x * d.y * d.z;                        // √(105 / 4π)
  if (i == 11) return 0.457045799f * d.y * (5.0f * d.z * d.z - 1.0f);        // √(21 / 32π)
  if (i == 12) return 0.373176333f * d.z * (5.0f * d.z * d.z - 3.0f);        // √(7 / 16π)
  if (i == 13) return 0.457045799f * d.x * (5.0f * d.z * d.z - 1.0f);
  if (i == 14) return 1.445305721f * d.z * (d.x * d.x - d.y * d.y);          // √(105 / 16π)
  return 0.590043589f * d.x * (d.x * d.x - 3.0f * d.y * d.y);
}

FN float harmonicOfBand4(int i, vec3 d) {
  float x2 = d.x * d.x;
  float y2 = d.y * d.y;
  float z2 = d.z * d.z;
  if (i == 16) return 2.503342942f * d.x * d.y * (x2 - y2);                  // √(315 / 16π)
  if (i == 17) return 1.770130769f * d.y * d.z * (3.0f * x2 - y2);           // √(315 / 32π)
  if (i == 18) return 0.946174696f * d.x * d.y * (7.0f * z2 - 1.0f);         // √(45 / 16π)
  if (i == 19) return 0.669046544f * d.y * d.z * (7.0f * z2 - 3.0f);         // √(45 / 32π)
  if (i == 20) return 0.105785547f * (z2 * (35.0f * z2 - 30.0f) + 3.0f);     // √(9 / 256π)
  if (i == 21) return 0.669046544f * d.x * d.z * (7.0f * z2 - 3.0f);
  if (i == 22) return 0.473087348f * (x2 - y2) * (7.0f * z2 - 1.0f);         // √(45 / 64π)
  if (i == 23) return 1.770130769f * d.x * d.z * (x2 - 3.0f * y2);
  return 0.625835735f * (x2 * (x2 - 3.0f * y2) - y2 * (3.0f * x2 - y2));     // √(315 / 256π)
}

FN float harmonic(int i, vec3 d) {
  if (i == 0) return 0.282094792f;                       // √(1 / 4π)
  if (i == 1) return 0.488602512f * d.y;                 // √(3 / 4π)
  if (i == 2) return 0.488602512f * d.z;
  if (i == 3) return 0.488602512f * d.x;
  if (i == 4) return 1.092548431f * d.x * d.y;           // √(15 / 4π)
  if (i == 5) return 1.092548431f * d.y * d.z;
  if (i == 6) return 0.315391565f * (3.0f * d.z * d.z - 1.0f);  // √(5 / 16π)
  if (i == 7) return 1.092548431f * d.x * d.z;
  if (i == 8) return 0.546274215f * (d.x * d.x - d.y * d.y);    // √(15 / 16π)
  if (i < 16) return harmonicOfBand3(i, d);
  return harmonicOfBand4(i, d);
}

// What the cosine lobe leaves of band l: A0 = π, A1 = 2π/3, A2 = π/4, A3 = 0, A4 = −π/24 (Ramamoorthi & Hanrahan 2001).
FN float cosineLobeBand(int l) {
  if (l == 0) return kPi;
  if (l == 1) return kTwoPi / 3.0f;
  if (l == 2) return kPi / 4.0f;
  if (l == 3) return 0.0f;
  return -kPi / 24.0f;
}

// Hann's window over bands up to `degree`: lessens the ripples around a small bright light, and blurs (Sloan 2008).
FN float harmonicWindow(int l, int degree) { return 0.5f + 0.5f * cos(kPi * float(l) / float(degree + 1)); }
