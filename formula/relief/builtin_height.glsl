// The built-in bumpy surfaces by number. Each is a function of the texture coordinate, vec3(∂h/∂u, ∂h/∂v, h): h lies in
// [0, 1], 1 is highest. It repeats after 1 in u and in v, without a seam. The gradient is exact; it has no jumps, and
// no wall is upright: the greatest slope is told with each. Needs: brick, cobbles, hammered, orange_skin, waves, weave.

const int kHeightFlat = 0;
const int kHeightOrange = 1;
const int kHeightBrick = 2;
const int kHeightCobbles = 3;
const int kHeightWeave = 4;
const int kHeightHammered = 5;
const int kHeightWaves = 6;

FN vec3 builtinHeight(int kind, vec2 uv) {
  if (kind == kHeightOrange) return orangeSkinHeight(uv);
  if (kind == kHeightBrick) return brickHeight(uv);
  if (kind == kHeightCobbles) return cobblesHeight(uv);
  if (kind == kHeightWeave) return weaveHeight(uv);
  if (kind == kHeightHammered) return hammeredHeight(uv);
  if (kind == kHeightWaves) return wavesHeight(uv);
  return vec3(0.0f, 0.0f, 0.0f);
}
