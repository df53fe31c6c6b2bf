// One sample's share of the mean over all samples of a pixel.
#include "color.glsl"

uniform sampler2D picture;
uniform float share;
uniform float as_displayed;  // 1: the mean is of what a display shows of each
uniform float exposure;
uniform int tone_map;

out vec4 fragment;

void main() {
  vec4 light = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  if (as_displayed > 0.5) light = displayLight(light, exposure, tone_map);
  fragment = light * share;
}
