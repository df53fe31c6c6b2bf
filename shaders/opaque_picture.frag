// A picture of opaque surfaces with how near they are, as shaders/surface/behind_screen.glsl reads it.
#include "nearness_of_depth.glsl"

uniform highp sampler2D picture;

out vec4 fragment;

void main() {
  const float kLargestHalf = 65504.0;
  vec3 light = texelFetch(picture, ivec2(gl_FragCoord.xy), 0).xyz;
  fragment = vec4(min(light, vec3(kLargestHalf)), nearnessOfDepth());
}
