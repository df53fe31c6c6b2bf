// Radiance, or what a display shows of it, with premultiplied alpha to an encoded picture with straight alpha, over a
// colour of the display. TONE_MAP is its tone map, by number.
#include "color.glsl"
#include "dither.glsl"

uniform sampler2D picture;
uniform float samples;       // by whose number each was divided before all were added up
uniform float count;         // of those that there are
uniform sampler2D counts;    // of the pixels that have finished; 0: as many as there are
uniform float has_counts;    // 1: `counts` is read
uniform float as_displayed;  // 1: `picture` is a display's light
uniform float exposure;
uniform vec4 backdrop;  // linear, premultiplied
uniform int dithered_rows;  // of the picture, whose codes are dithered; 0: they are not

out vec4 fragment;

void main() {
  float of_pixel = has_counts > 0.5 ? texelFetch(counts, ivec2(gl_FragCoord.xy), 0).x : 0.0;
  vec4 light = texelFetch(picture, ivec2(gl_FragCoord.xy), 0) * (samples / (of_pixel > 0.0 ? of_pixel : count));
  if (as_displayed < 0.5) light = displayLight(light, exposure, TONE_MAP);
  fragment = encodedPicture(laidOver(light, backdrop));
  if (dithered_rows > 0) {
    ivec2 from_top = ivec2(int(gl_FragCoord.x), dithered_rows - 1 - int(gl_FragCoord.y));
    fragment = vec4(dithered(vec3(fragment), from_top), fragment.w);
  }
}
