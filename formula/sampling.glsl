// Where in a pixel or texel the samples lie.

// The i-th point of the R2 sequence in [0, 1)² (Martin Roberts 2018): any number of points from the start covers the
// square evenly, and the first is its centre. The steps are 1/g and 1/g², g the real root of x³ = x + 1.
FN vec2 sampleOffset(int i) {
  return fract(vec2(0.5f, 0.5f) + float(i) * vec2(0.754877666f, 0.569840291f));
}

// The mip level whose texels are about as large as what one sample of a pixel sees of a map: from the direction's change
// to the next pixel across and down, by the area that the two span, so that a long narrow footprint is not blurred in its
// narrow direction as far as in its long one.
FN float footprintLod(vec3 across, vec3 down, float texels_per_radian, float samples) {
  float area = length(cross(across, down)) * texels_per_radian * texels_per_radian / samples;
  return max(log2(max(area, 1e-12f)) / 2.0f, 0.0f);
}
