// Ordered dithering: where a picture of 8 bits has no code for a value, some pixels take the code below and others the
// code above, so that their mean is the value and a gradient shows no steps.

const int kDitherLevels = 64;

// The level of a pixel, from 0 to kDitherLevels − 1: neighbours have levels far apart, and every patch of pixels has
// all of them nearly equally often. It is x / g + y / g² modulo 1 with g the real root of x³ = x + 1, folded into a
// triangle wave so that it has no jump (Martin Roberts 2018, "The Unreasonable Effectiveness of Quasirandom
// Sequences"). The factors are multiples of 2⁻³²: unsigned integers wrap round as the fraction does.
//   pixel   column and row
FN int ditherLevel(ivec2 pixel) {
  uint phase = uint(pixel.x) * 3242174889u + uint(pixel.y) * 2447445414u;
  uint wave = phase < 2147483648u ? phase << 1u : ~(phase << 1u);
  return int(wave >> 26u);
}

// What is added to a value, in codes, before it is rounded down: between 0 and 1, and 0.5 in the mean. A value that is
// within 1/128 of a code has that code in every pixel.
FN float ditherThreshold(int level) { return (float(level) + 0.5f) / float(kDitherLevels); }

// The code of a pixel, divided by 255, for an encoded colour in [0, 1].
FN vec3 dithered(vec3 encoded, ivec2 pixel) {
  return floor(encoded * 255.0f + ditherThreshold(ditherLevel(pixel))) / 255.0f;
}
