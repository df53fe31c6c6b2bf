// Part "dispersion": the kinds of light that go their own ways through glass that disperses.
//   int lightKinds(bool disperses)                  how many there are
//   vec3 shareOfKind(int kind, bool disperses)      what one counts for in red, green and blue; all of them for 1
//   float iorOfKind(RefractiveIndex index, int kind)
// Here: red, green and blue.

int lightKinds(bool disperses) { return disperses ? 3 : 1; }

vec3 shareOfKind(int kind, bool disperses) {
  vec3 share = vec3(0.0);
  share[kind] = 1.0;
  return disperses ? share : vec3(1.0);
}

float iorOfKind(RefractiveIndex index, int kind) { return iorOfChannels(index.ior, index.dispersion)[kind]; }
