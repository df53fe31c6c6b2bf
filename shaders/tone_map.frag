// Radiance, or what a display shows of it, with premultiplied alpha to an encoded picture with straight alpha, over a
// colour of the display.
#include "color.glsl"

uniform sampler2D picture;
uniform float share;         // what makes a mean of the sum of those samples that there are
uniform float as_displayed;  // 1: `picture` is a display's light
uniform float exposure;
uniform int tone_map;
uniform vec4 backdrop;  // linear, premultiplied

out vec4 fragment;

void main() {
  vec4 light = texelFetch(picture, ivec2(gl_FragCoord.xy), 0) * share;
  if (as_displayed < 0.5) light = displayLight(light, exposure, tone_map);
  fragment = encodedPicture(laidOver(light, backdrop));
}
