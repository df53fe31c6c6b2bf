// One face of a cube of irradiance, divided by π: the sum over all texels of a coarse mip level with their cosines and
// solid angles, as a share of what it is in white light.
#include "cube.glsl"

uniform samplerCube cube;
uniform float level;
uniform int source_size;
uniform int size;
uniform int face;

out vec4 fragment;

void main() {
  vec3 n = normalize(cubePoint(face, gl_FragCoord.xy / float(size)));
  vec4 sum = vec4(0.0);
  for (int from = 0; from < 6; ++from)
    for (int y = 0; y < source_size; ++y)
      for (int x = 0; x < source_size; ++x) {
        vec2 st = (vec2(x, y) + 0.5) / float(source_size);
        vec3 d = cubePoint(from, st);
        float weight = max(dot(n, normalize(d)), 0.0) * cubeTexelSolidAngle(st, float(source_size));
        if (weight > 0.0) sum += weight * vec4(sampleLod(cube, d, level).xyz, 1.0);
      }
  fragment = vec4(sum.xyz / sum.w, 1.0);
}
