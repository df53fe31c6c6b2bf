// Woven metal. Needs: constants, dual.

// A strand that goes over and under others, vec3(slope across it, slope along it, height), 0 beside it.
//   across   from its middle, −½ to ½ where the next one begins
//   along    its crossings are at the whole numbers
//   over     1: it goes over the strand at 0; −1: under it
// Its middle line is a cosine, its cross-section an ellipse whose ends, which would be upright, are left out; a ramp
// leads down from there.
FN vec3 strandHeight(float across, float along, float over) {
  float x = 2.0f * across;
  float section = sqrt(1.0f - 0.97f * x * x);
  vec3 strand = vec3(0.65f * -1.94f * x / section, -0.33f * over * kPi * sin(kPi * along),
                     0.32f + 0.65f * section + 0.33f * over * cos(kPi * along));
  return dualProduct(strand, dualSmoothstep(0.0f, 0.14f, vec3(-sign(across), 0.0f, 0.5f - abs(across))));
}

// Plain weave of 8 × 8 strands, metal bands or, if the relief is deep, wires. Greatest slope 55, at the strands' sides;
// mean height 0.77.
FN vec3 weaveHeight(vec2 uv) {
  vec2 p = 8.0f * fract(uv);
  vec2 strand = floor(p);
  vec2 across = p - strand - 0.5f;
  vec2 over = 1.0f - 2.0f * mod(strand, vec2(2.0f));
  vec3 warp = strandHeight(across.x, p.y - 0.5f, over.x);
  vec3 weft = strandHeight(across.y, p.x - 0.5f, -over.y);
  vec3 height = dualMaximum(warp, vec3(weft.y, weft.x, weft.z), 0.03f);
  return 0.75f * dualOfFiner(height, 8.0f);
}
