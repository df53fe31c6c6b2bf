// The analytic daylight of Preetham, Shirley & Smits, "A practical analytic model for daylight", SIGGRAPH 1999.
// Needs: constants, color. Turbidity T is 2 for very clear to 10 for hazy air; the fit holds between those.

// Perez' distribution F(θ, γ) with the five coefficients of one quantity.
FN float perez(float cos_theta, float gamma, float a, float b, float c, float d, float e) {
  float cos_gamma = cos(gamma);
  return (1.0f + a * exp(b / max(cos_theta, 0.01f))) * (1.0f + c * exp(d * gamma) + e * cos_gamma * cos_gamma);
}

// Zenith chromaticity: a polynomial of third degree in the sun's angle θs, of second in T (paper, appendix A.2).
FN float zenithChromaticity(float theta, float turbidity, vec4 t2, vec4 t1, vec4 t0) {
  vec4 powers = vec4(theta * theta * theta, theta * theta, theta, 1.0f);
  return turbidity * turbidity * dot(t2, powers) + turbidity * dot(t1, powers) + dot(t0, powers);
}

// Zenith luminance in kcd/m² (paper, appendix A.2).
FN float zenithLuminance(float theta, float turbidity) {
  float chi = (4.0f / 9.0f - turbidity / 120.0f) * (kPi - 2.0f * theta);
  return max((4.0453f * turbidity - 4.9710f) * tan(chi) - 0.2155f * turbidity + 2.4192f, 0.0f);
}

// Sky luminance and colour seen along d (d.y ≥ 0), for a sun in direction `sun`; linear Rec.709 in kcd/m².
FN vec3 skyLuminance(vec3 d, vec3 sun, float turbidity) {
  float cos_theta = max(d.y, 0.0f);
  float theta_sun = acos(clamp(sun.y, 0.0f, 1.0f));
  float gamma = acos(clamp(dot(d, sun), -1.0f, 1.0f));
  float t = turbidity;

  float aY = 0.1787f * t - 1.4630f;
  float bY = -0.3554f * t + 0.4275f;
  float cY = -0.0227f * t + 5.3251f;
  float dY = 0.1206f * t - 2.5771f;
  float eY = -0.0670f * t + 0.3703f;
  float ax = -0.0193f * t - 0.2592f;
  float bx = -0.0665f * t + 0.0008f;
  float cx = -0.0004f * t + 0.2125f;
  float dx = -0.0641f * t - 0.8989f;
  float ex = -0.0033f * t + 0.0452f;
  float ay = -0.0167f * t - 0.2608f;
  float by = -0.0950f * t + 0.0092f;
  float cy = -0.0079f * t + 0.2102f;
  float dy = -0.0441f * t - 1.6537f;
  float ey = -0.0109f * t + 0.0529f;

  float zenith_x = zenithChromaticity(theta_sun, t, vec4(0.00166f, -0.00375f, 0.00209f, 0.0f),
                                      vec4(-0.02903f, 0.06377f, -0.03202f, 0.00394f),
                                      vec4(0.11693f, -0.21196f, 0.06052f, 0.25886f));
  float zenith_y = zenithChromaticity(theta_sun, t, vec4(0.00275f, -0.00610f, 0.00317f, 0.0f),
                                      vec4(-0.04214f, 0.08970f, -0.04153f, 0.00516f),
                                      vec4(0.15346f, -0.26756f, 0.06670f, 0.26688f));
  float light = zenithLuminance(theta_sun, t) * perez(cos_theta, gamma, aY, bY, cY, dY, eY) /
                perez(1.0f, theta_sun, aY, bY, cY, dY, eY);
  float x = zenith_x * perez(cos_theta, gamma, ax, bx, cx, dx, ex) / perez(1.0f, theta_sun, ax, bx, cx, dx, ex);
  float y = zenith_y * perez(cos_theta, gamma, ay, by, cy, dy, ey) / perez(1.0f, theta_sun, ay, by, cy, dy, ey);
  return max(rec709FromXyz(vec3(x / y, 1.0f, (1.0f - x - y) / y) * light), vec3(0.0f));
}
