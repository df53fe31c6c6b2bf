// How a map goes on beyond its edges (OpenGL 4.6, section 8.14.2).

const int kWrapRepeat = 0;
const int kWrapMirroredRepeat = 1;
const int kWrapClampToEdge = 2;

// Which of `size` texels stands for one that may lie beyond the edges.
FN float wrappedTexel(float texel, float size, int wrap) {
  if (wrap == kWrapClampToEdge) return clamp(texel, 0.0f, size - 1.0f);
  float period = wrap == kWrapMirroredRepeat ? 2.0f * size : size;
  // Counted from the texel's centre: a quotient that is a whole number may come out just below it.
  float within = texel - period * floor((texel + 0.5f) / period);
  return wrap == kWrapMirroredRepeat ? min(within, period - 1.0f - within) : within;
}
