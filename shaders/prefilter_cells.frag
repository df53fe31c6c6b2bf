// Sums over the cells of a cube's faces, 8 × 8 texels each, the faces side by side: of the light, or of the texels that
// exceed thresholds.
#include "bright_light.glsl"
#include "cube.glsl"

uniform samplerCube cube;
uniform int size;
uniform int cells;  // across a face
#ifdef COUNT_ABOVE
uniform sampler2D thresholds;
#endif

out vec4 fragment;

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  int face = cell.x / cells;
  ivec2 begin = ivec2(cell.x % cells, cell.y) * 8;
  ivec2 end = min(begin + 8, ivec2(size));
  vec4 sum = vec4(0.0);
  for (int y = begin.y; y < end.y; ++y)
    for (int x = begin.x; x < end.x; ++x) {
      vec2 st = (vec2(x, y) + 0.5) / float(size);
      vec3 light = sampleLod(cube, cubePoint(face, st), 0.0).xyz;
#ifdef COUNT_ABOVE
      sum += thresholdsExceeded(light, texelFetch(thresholds, ivec2(0), 0));
#else
      sum += vec4(brightness(light) * cubeTexelSolidAngle(st, float(size)));
#endif
    }
  fragment = sum;
}
