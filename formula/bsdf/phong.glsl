// A lobe about the mirror direction (Phong 1975), scaled to reflect all light that comes along the normal (Lewis 1994).
// The frame and the names are diffuse.glsl's; v is towards the eye.
// Needs: constants, tangent.

FN vec3 phongMirror(vec3 v) { return vec3(-v.x, -v.y, v.z); }

FN float evalPhong(float exponent, vec3 v, vec3 l) {
  return (exponent + 2.0f) / kTwoPi * pow(max(dot(phongMirror(v), l), 0.0f), exponent);
}

// May lie below the horizon, where nothing is reflected.
FN vec3 samplePhong(float exponent, vec3 v, vec2 u) {
  float cosine = pow(1.0f - u.x, 1.0f / (exponent + 1.0f));
  float sine = sqrt(max(1.0f - cosine * cosine, 0.0f));
  vec3 mirror = phongMirror(v);
  vec3 t = anyTangent(mirror);
  return mirror * cosine + (t * cos(kTwoPi * u.y) + cross(mirror, t) * sin(kTwoPi * u.y)) * sine;
}

FN float pdfPhong(float exponent, vec3 v, vec3 l) {
  return (exponent + 1.0f) / kTwoPi * pow(max(dot(phongMirror(v), l), 0.0f), exponent);
}
