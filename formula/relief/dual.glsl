// Numbers that carry their slopes: vec3(∂/∂u, ∂/∂v, value), dual numbers of two variables. Sums and multiples are those
// of vectors; what is not linear follows the chain rule (Wengert 1964, "A simple automatic derivative evaluation
// program"). A height that is put together from them has its exact gradient.

// The same quantity by coordinates that are `scale` times finer: f(scale · uv) from f and its slopes.
FN vec3 dualOfFiner(vec3 a, float scale) { return vec3(scale * vec2(a), a.z); }

FN vec3 dualProduct(vec3 a, vec3 b) { return vec3(a.z * vec2(b) + b.z * vec2(a), a.z * b.z); }

// GLSL's smoothstep, 0 at `from` and 1 at `to`, level at both and beyond; `from` may also be the greater one.
FN vec3 dualSmoothstep(float from, float to, vec3 a) {
  float t = clamp((a.z - from) / (to - from), 0.0f, 1.0f);
  return vec3(6.0f * t * (1.0f - t) / (to - from) * vec2(a), t * t * (3.0f - 2.0f * t));
}

// max(a, b) with its crease rounded off: a hyperbola, `rounding` / 2 above both where they are equal.
FN vec3 dualMaximum(vec3 a, vec3 b, float rounding) {
  float apart = a.z - b.z;
  float root = sqrt(apart * apart + rounding * rounding);
  vec2 slopes = vec2(a) + vec2(b) + apart / root * (vec2(a) - vec2(b));
  return 0.5f * vec3(slopes, a.z + b.z + root);
}
