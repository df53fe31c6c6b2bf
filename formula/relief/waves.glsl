// Water with waves. Needs: constants.

const int kWaves = 14;

// The waves that make up the water: vec4(wave vector, amplitude, phase in turns). Wave vectors count the crests along
// the tile's sides and are whole numbers, so that the tile repeats. They are 2 to 20 long and spread by some 40° about
// the wind; amplitudes fall as their length^−1.4, times 0.85 to 1.15. Drawn by lot, and written down.
FN vec4 waveNumber(int i) {
  switch (i) {
    case 0:
      return vec4(2.0f, -1.0f, 0.1732f, 0.51f);
    case 1:
      return vec4(3.0f, 0.0f, 0.1049f, 0.51f);
    case 2:
      return vec4(3.0f, 2.0f, 0.0844f, 0.09f);
    case 3:
      return vec4(4.0f, 1.0f, 0.0787f, 0.04f);
    case 4:
      return vec4(0.0f, 5.0f, 0.0587f, 0.16f);
    case 5:
      return vec4(5.0f, 2.0f, 0.0517f, 0.06f);
    case 6:
      return vec4(5.0f, 4.0f, 0.0398f, 0.44f);
    case 7:
      return vec4(6.0f, 6.0f, 0.0272f, 0.64f);
    case 8:
      return vec4(9.0f, 2.0f, 0.0225f, 0.0f);
    case 9:
      return vec4(11.0f, -1.0f, 0.0207f, 0.71f);
    case 10:
      return vec4(9.0f, 8.0f, 0.0144f, 0.77f);
    case 11:
      return vec4(5.0f, 14.0f, 0.0137f, 0.39f);
    case 12:
      return vec4(15.0f, 10.0f, 0.0086f, 0.91f);
    case 13:
      return vec4(17.0f, 11.0f, 0.0092f, 0.40f);
    default:
      return vec4(0.0f, 0.0f, 0.0f, 0.0f);
  }
}

// Real water moves in circles: crests draw together and sharpen, troughs widen (Gerstner 1802; Tessendorf 2001,
// "Simulating ocean water", 4.5). Water at rest at x is carried to x − D(x), where D = Σ a k / |k| sin φ times the
// choppiness. So the height at a place is that of the water which is at rest about D beside it, and its slope follows
// by the chain rule from D's slopes along u and v. Greatest slope 37, mean height 0.43.
FN vec3 wavesHeight(vec2 uv) {
  const float kChoppiness = 0.18f;
  vec2 p = fract(uv);
  vec2 at_rest = p;
  vec2 across_u = vec2(1.0f, 0.0f);
  vec2 across_v = vec2(0.0f, 1.0f);
  for (int i = 0; i < kWaves; ++i) {
    vec4 wave = waveNumber(i);
    vec2 k = vec2(wave);
    float phase = kTwoPi * fract(dot(k, p) + wave.w);
    vec2 shift = kChoppiness * wave.z / length(k) * k;
    at_rest += sin(phase) * shift;
    across_u += kTwoPi * cos(phase) * k.x * shift;
    across_v += kTwoPi * cos(phase) * k.y * shift;
  }
  vec3 height = vec3(0.0f, 0.0f, 0.53f);
  for (int i = 0; i < kWaves; ++i) {
    vec4 wave = waveNumber(i);
    vec2 k = vec2(wave);
    float phase = kTwoPi * fract(dot(k, at_rest) + wave.w);
    height += wave.z * vec3(-kTwoPi * sin(phase) * k, cos(phase));
  }
  return vec3(dot(vec2(height), across_u), dot(vec2(height), across_v), height.z);
}
