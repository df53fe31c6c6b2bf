// One sample's share of the mean over all samples of a pixel. TONE_MAP is the display's, by number.
#include "color.glsl"

uniform sampler2D picture;
uniform float share;
uniform float as_displayed;  // 1: the mean is of what a display shows of each
uniform float exposure;

out vec4 fragment;

void main() {
  vec4 light = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  if (as_displayed > 0.5) light = displayLight(light, exposure, TONE_MAP);
  fragment = light * share;
}
