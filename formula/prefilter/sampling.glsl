// Where in a pixel or texel the samples lie.

// Points in [0, 1)² that cover the square evenly, however many there are: the R2 sequence (Martin Roberts 2018), whose
// steps are 1/g and 1/g² with g the real root of x³ = x + 1.
//   from   where it begins
FN vec2 evenPoint(vec2 from, float i) { return fract(from + i * vec2(0.754877666f, 0.569840291f)); }

// The i-th of `count` of them. Each point is followed by its mirror image, and an odd count has one in the centre, so
// that their mean is the centre itself and no picture is shifted.
FN vec2 sampleOffset(int i, int count) {
  int in_pairs = i - count % 2;
  if (in_pairs < 0) return vec2(0.5f, 0.5f);
  vec2 p = evenPoint(vec2(0.5f, 0.5f), float(in_pairs / 2) + 0.5f);
  return in_pairs % 2 == 0 ? p : vec2(1.0f, 1.0f) - p;
}

// Which of `lobes` parts of what a sample sees one of a row of lobes reads: there are 2 in each column, numbered
// upwards and then to the right, so that part p and part lobes − 1 − p are mirror images about the middle. The lobes of
// a sample read all parts, and neighbours in the row, which are much alike, read mirror images. So does one lobe in the
// samples of a pair: so no picture is shifted, nor changes much where some pixels take a first pair alone. In as many
// samples as there are lobes, each lobe reads all parts.
//   lobes     2, 4 or 6
//   i         the sample, of `samples`
//   returns   −1: the whole, of the sample in the centre, or of fewer samples than lobes
FN int partOfLobe(int lobe, int lobes, int i, int samples) {
  int in_pairs = i - samples % 2;
  if (samples < lobes || in_pairs < 0) return -1;
  int part = (lobe / 2 + in_pairs / 2) % (lobes / 2);
  bool is_image = lobe % 2 != in_pairs % 2;
  return is_image ? lobes - 1 - part : part;
}

// A sample's own footprint on a surface is read in so many strata, the cells of a grid, where each of them looks
// another way.
const int kStrataAcross = 4;
const int kStrata = kStrataAcross * kStrataAcross;

// Where the i-th of them lies from the middle, in footprints: at random in its place of a grid.
//   random   in [0, 1)², of the sample
FN vec2 placeInStratum(int i, vec2 random) {
  vec2 corner = vec2(float(i % kStrataAcross), float(i / kStrataAcross));
  vec2 inside = evenPoint(random, float(i));
  return (corner + inside) / float(kStrataAcross) - 0.5f;
}

// The solid angle that one sample of a pixel sees, in steradians: from the direction's change to the next pixel across
// and down.
FN float sampleFootprint(vec3 across, vec3 down, float samples) { return length(cross(across, down)) / samples; }

// The mip level of a map whose texels are about as large as that: by the area, so that a long narrow footprint is not
// blurred in its narrow direction as far as in its long one.
FN float footprintLod(float footprint, float texels_per_radian) {
  return max(log2(max(footprint * texels_per_radian * texels_per_radian, 1e-12f)) / 2.0f, 0.0f);
}
