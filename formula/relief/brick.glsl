// A wall of bricks. Needs: grid_random, dual, relief_noise.

// Running bond: 12 rows of 4 bricks, each row shifted by half a brick, which with their joints are three times as long
// as high. Each brick lies deeper or less deep than its neighbours and is a little tilted; its edges are not quite
// straight, its faces lumpy and pitted, the mortar sandy. Greatest slope 101, in the bevelled edges; mean
// height 0.52.
FN vec3 brickHeight(vec2 uv) {
  const vec2 kBricks = vec2(4.0f, 12.0f);
  vec2 p = fract(uv);
  vec2 place = kBricks * p;
  place.x += 0.5f * mod(floor(place.y), 2.0f);
  vec2 brick = floor(place);
  vec2 from_middle = place - brick - 0.5f;
  vec3 random = cellRandom(ivec2(brick), ivec2(kBricks), 0);
  vec3 lumps = dualOfFiner(reliefNoise(24.0f * p, 24, 1), 24.0f);
  vec3 grain = dualOfFiner(reliefNoise(72.0f * p, 72, 2), 72.0f);

  // How far inside of its cell a place is, in heights of a row. The joint, where `brick_share` is 0, is wider than the
  // lumps move it: what changes from brick to brick changes unseen.
  vec3 from_side = vec3(-kBricks.y * sign(from_middle.x), 0.0f, 3.0f * (0.5f - abs(from_middle.x))) + 0.06f * lumps;
  vec3 from_bed = vec3(0.0f, -kBricks.y * sign(from_middle.y), 0.5f - abs(from_middle.y)) + 0.06f * lumps;
  vec3 brick_share = dualProduct(dualSmoothstep(0.045f, 0.21f, from_side), dualSmoothstep(0.045f, 0.21f, from_bed));

  vec2 tilt = vec2(0.26f, 0.2f) * (vec2(random) - 0.5f);
  vec3 face = vec3(tilt * kBricks, 0.57f + 0.25f * random.z + dot(tilt, from_middle)) + 0.25f * lumps -
              0.16f * dualSmoothstep(0.15f, 0.6f, grain);
  vec3 mortar = vec3(0.0f, 0.0f, 0.15f) + 0.14f * grain + 0.1f * lumps;
  return mortar + dualProduct(brick_share, face - mortar);
}
