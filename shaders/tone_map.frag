// Radiance with premultiplied alpha to an encoded picture with straight alpha.
#include "color.glsl"

uniform sampler2D picture;
uniform float exposure;
uniform int tone_map;

out vec4 fragment;

void main() {
  vec4 radiance = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  fragment = displayed(radiance, exposure, tone_map);
}
