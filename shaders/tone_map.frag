// Radiance with premultiplied alpha to an encoded picture with straight alpha, over a colour of the display.
#include "color.glsl"

uniform sampler2D picture;
uniform float exposure;
uniform int tone_map;
uniform vec4 backdrop;  // linear, premultiplied

out vec4 fragment;

void main() {
  vec4 radiance = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  fragment = encodedPicture(laidOver(displayLight(radiance, exposure, tone_map), backdrop));
}
