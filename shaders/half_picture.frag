// A picture of light as half floats hold it: none is infinite.
uniform highp sampler2D picture;

out vec4 fragment;

void main() {
  const float kLargestHalf = 65504.0;
  fragment = min(texelFetch(picture, ivec2(gl_FragCoord.xy), 0), vec4(kLargestHalf));
}
