// One face of a mip level: each texel the mean of those that it covers of the level before, by the light that they stand
// for.
#include "cube.glsl"

uniform samplerCube cube;  // only the level before
uniform int source_size;
uniform int size;
uniform int face;

out vec4 fragment;

void main() {
  vec2 begin = floor(gl_FragCoord.xy) * float(source_size) / float(size);
  vec2 end = begin + float(source_size) / float(size);
  vec4 sum = vec4(0.0);
  for (int y = int(begin.y); float(y) < end.y - 1e-3; ++y)
    for (int x = int(begin.x); float(x) < end.x - 1e-3; ++x) {
      vec2 texel = vec2(x, y);
      vec2 overlap = min(texel + 1.0, end) - max(texel, begin);
      vec2 st = (texel + 0.5) / float(source_size);
      float weight = overlap.x * overlap.y * cubeTexelSolidAngle(st, float(source_size));
      sum += weight * vec4(sampleLod(cube, cubePoint(face, st), 0.0).xyz, 1.0);
    }
  fragment = vec4(sum.xyz / sum.w, 1.0);
}
