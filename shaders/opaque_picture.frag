// A picture of opaque surfaces, as shaders/surface/behind_screen.glsl reads it.
uniform sampler2D picture;
uniform highp sampler2D nearness;

out vec4 fragment;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  const float kLargestHalf = 65504.0;
  fragment = vec4(min(texelFetch(picture, texel, 0).xyz, vec3(kLargestHalf)), texelFetch(nearness, texel, 0).x);
}
