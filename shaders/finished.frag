// The pixels that need no more samples, with their number of samples: those in which the last one is so much as the
// mean of all until now, and as its neighbours, that a display would hardly show what more would change. Its
// neighbours' changes count too, since edges go on from pixel to pixel. TONE_MAP is the display's, by number.
#include "color.glsl"

uniform sampler2D last;     // a sample's radiance
uniform sampler2D sum;      // of all until now, of what a display shows of each
uniform float mean_of_sum;  // the factor that makes their mean of it
uniform float count;        // of them, at least 2
uniform float exposure;

out vec4 fragment;

// A display's steps are about even in the square root of its light.
vec4 lastAt(ivec2 at) { return sqrt(displayLight(texelFetch(last, at, 0), exposure, TONE_MAP)); }
float difference(vec4 a, vec4 b) {
  vec4 d = abs(a - b);
  return max(max(d.x, d.y), max(d.z, d.w));
}

void main() {
  // Of a display's range. One of `count` samples, which are spread evenly, moves their mean by its share. From the mean
  // of the others it is count / (count − 1) times as far as from that of all.
  const float kChange = 0.01;
  const float kContrast = 0.06;
  const float kMost = 8.0;  // with more samples what is allowed grows no further
  const ivec2 kSteps[5] = ivec2[5](ivec2(0, 0), ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 corner = textureSize(last, 0) - 1;
  vec4 middle = lastAt(here);
  float change = 0.0;
  float contrast = 0.0;
  for (int i = 0; i < 5; ++i) {
    ivec2 at = clamp(here + kSteps[i], ivec2(0, 0), corner);
    vec4 shown = i == 0 ? middle : lastAt(at);
    change = max(change, difference(shown, sqrt(max(texelFetch(sum, at, 0) * mean_of_sum, 0.0))));
    contrast = max(contrast, difference(shown, middle));
  }
  float allowed = min(count, kMost);
  if (change > kChange * (allowed - 1.0) || contrast > kContrast * allowed) discard;
  fragment = vec4(count);
}
