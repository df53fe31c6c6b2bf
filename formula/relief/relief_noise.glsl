// What is random in reliefs that repeat. Needs: grid_random.

// Three numbers in [0, 1) for a cell of a grid that repeats.
//   cell     from −period up to 2 · period
//   period   after how many cells, to the right and downwards
//   layer    a number of the use: other layers are independent
FN vec3 cellRandom(ivec2 cell, ivec2 period, int layer) {
  ivec3 wrapped = ivec3(cell, layer);  // without a division, which GPUs have none for whole numbers
  if (cell.x < 0) wrapped.x += period.x;
  if (cell.y < 0) wrapped.y += period.y;
  if (cell.x >= period.x) wrapped.x -= period.x;
  if (cell.y >= period.y) wrapped.y -= period.y;
  return gridRandom(wrapped);
}

// The random plane through 0 at a corner of the grid: vec3(its slopes, its value at `way` from the corner).
FN vec3 cornerPlane(ivec2 corner, vec2 way, int period, int layer) {
  vec2 slopes = 2.0f * vec2(cellRandom(corner, ivec2(period), layer)) - 1.0f;
  return vec3(slopes, dot(slopes, way));
}

// Gradient noise (Perlin 2002, "Improving noise"), which blends the planes of four corners by 6 t⁵ − 15 t⁴ + 10 t³:
// vec3(∂/∂x, ∂/∂y, value). Its cells are 1 wide. The mean is 0, the values lie within ±1, in practice within ±0.8.
//   place    in [0, period]²
//   period   after so many cells it repeats
FN vec3 reliefNoise(vec2 place, int period, int layer) {
  vec2 corner = floor(place);
  vec2 t = place - corner;
  vec2 fade = t * t * t * (t * (6.0f * t - 15.0f) + 10.0f);
  vec2 fade_slope = 30.0f * t * t * (t - 1.0f) * (t - 1.0f);
  ivec2 cell = ivec2(corner);
  vec3 plane_00 = cornerPlane(cell, t, period, layer);
  vec3 plane_10 = cornerPlane(cell + ivec2(1, 0), t - vec2(1.0f, 0.0f), period, layer);
  vec3 plane_01 = cornerPlane(cell + ivec2(0, 1), t - vec2(0.0f, 1.0f), period, layer);
  vec3 plane_11 = cornerPlane(cell + ivec2(1, 1), t - vec2(1.0f, 1.0f), period, layer);
  vec3 low = mix(plane_00, plane_10, fade.x);
  vec3 high = mix(plane_01, plane_11, fade.x);
  float rise_x = mix(plane_10.z - plane_00.z, plane_11.z - plane_01.z, fade.y);
  return mix(low, high, fade.y) + vec3(fade_slope.x * rise_x, fade_slope.y * (high.z - low.z), 0.0f);
}

// One of the points around a place that lie scattered, one in each cell of a grid (Worley 1996, "A cellular texture
// basis function"): vec3(way from the place to it, a random number in [0, 1)). Every second row is shifted by half a
// cell, so that points have six neighbours rather than eight. Other points than those of the nearest 2 × 2 cells are
// at least 1 − jitter / 2 away from the place, other than those of 3 × 3 cells 1.5 − jitter / 2.
//   place    in [0, period]²; cells are 1 wide
//   i        0 to count² − 1
//   count    2 or 3 cells in each direction
//   jitter   0: all in the middle of their cells; 1: anywhere in them
//   period   even
FN vec3 scatteredPoint(vec2 place, int i, int count, float jitter, int period, int layer) {
  vec2 first = place - 0.5f * float(count - 1);
  float row = floor(first.y) + float(i / count);
  float shift = 0.5f * mod(row, 2.0f);
  float column = floor(first.x + shift) + float(i % count);
  vec3 random = cellRandom(ivec2(int(column), int(row)), ivec2(period), layer);
  vec2 point = vec2(column - shift, row) + 0.5f + jitter * (vec2(random) - 0.5f);
  return vec3(point - place, random.z);
}
