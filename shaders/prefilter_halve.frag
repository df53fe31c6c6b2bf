// One face of a mip level: each texel the mean of 4 × 4 of the level before with the weights 1 3 3 1 across and down,
// times the light that they stand for. Unlike boxes these leave a lamp where it is, and blur it as far wherever it
// falls between the texels, so that wide reads of coarse levels add up to smooth lobes; Manson & Sloan 2016 ("Fast
// filtering of reflection probes") take them too. Four linear reads,
// each a quarter of a texel beside an inner texel's centre.
#include "cube.glsl"

uniform samplerCube cube;  // only the level before
uniform int source_size;
uniform int size;
uniform int face;

out vec4 fragment;

void main() {
  vec2 centre = gl_FragCoord.xy / float(size);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    vec2 side = vec2(i % 2 == 0 ? -0.75 : 0.75, i / 2 == 0 ? -0.75 : 0.75);
    vec2 st = centre + side / float(source_size);
    sum += cubeTexelSolidAngle(st, float(source_size)) * vec4(sampleLod(cube, cubePoint(face, st), 0.0).xyz, 1.0);
  }
  fragment = vec4(sum.xyz / sum.w, 1.0);
}
