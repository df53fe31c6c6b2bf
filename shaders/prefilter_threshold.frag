// One pixel: how bright a texel must be to become a point of light. Three stages, each from sums over all blocks:
// coarse thresholds from the light, fine ones from how many texels exceed the coarse ones, and the one chosen of those.
#include "bright_light.glsl"
#include "constants.glsl"

uniform int stage;
uniform float max_count;            // points of light
uniform sampler2D blocks;      // of the light, or of counts
uniform sampler2D thresholds;  // that were counted

out vec4 fragment;  // four thresholds; in the end the threshold, the channel of its counts and how many exceed it

vec4 sumOfBlocks() {
  ivec2 extent = textureSize(blocks, 0);
  vec4 sum = vec4(0.0);
  for (int y = 0; y < extent.y; ++y)
    for (int x = 0; x < extent.x; ++x) sum += texelFetch(blocks, ivec2(x, y), 0);
  return sum;
}

void main() {
  vec4 sum = sumOfBlocks();
  if (stage == 0) {
    fragment = coarseThresholds(sum.x / (2.0 * kTwoPi));
    return;
  }
  vec4 counted = texelFetch(thresholds, ivec2(0), 0);
  if (stage == 1) {
    fragment = fineThresholds(counted, sum, max_count);
    return;
  }
  int chosen = firstWithin(sum, max_count);
  fragment = chosen < 4 ? vec4(counted[chosen], float(chosen), sum[chosen], 0.0) : vec4(1e30, 0.0, 0.0, 0.0);
}
