// Woven metal. Needs: constants, dual.

// A strand that goes over and under others, vec3(slope across it, slope along it, height), 0 beside it.
//   across   from its middle, −½ to ½ where the next one begins
//   along    its crossings are at the whole numbers
//   over     1: it goes over the strand at 0; −1: under it
// Its middle line is a cosine, its cross-section an ellipse whose ends, which would be upright, are left out; a ramp
// leads down from there.
FN vec3 strandHeight(float across, float along, float over) {
  float x = 2.0f * across;
  float section = sqrt(1.0f - 0.9f * x * x);
  vec3 strand = vec3(0.58f * -1.8f * x / section, -0.4f * over * kPi * sin(kPi * along),
                     1.0f + 0.58f * section + 0.4f * over * cos(kPi * along));
  return dualProduct(strand, dualSmoothstep(0.0f, 0.13f, vec3(-sign(across), 0.0f, 0.5f - abs(across))));
}

// Plain weave of 8 × 8 strands, round ones like wires or, where it is low, flat ones like bands. Greatest slope
// SLOPE_WEAVE, at the strands' sides; mean height MEAN_WEAVE.
FN vec3 weaveHeight(vec2 uv) {
  vec2 p = 8.0f * fract(uv);
  vec2 strand = floor(p);
  vec2 across = p - strand - 0.5f;
  vec2 over = 1.0f - 2.0f * mod(strand, vec2(2.0f));
  vec3 warp = strandHeight(across.x, p.y - 0.5f, over.x);
  vec3 weft = strandHeight(across.y, p.x - 0.5f, -over.y);
  vec3 height = dualMaximum(warp, vec3(weft.y, weft.x, weft.z), 0.03f);
  return 0.5f * dualOfFiner(height, 8.0f);
}
