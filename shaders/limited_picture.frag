// A picture of light in another unit, and of what is too large for that the most that it holds.
uniform highp sampler2D picture;
uniform float factor;
uniform float most;

out vec4 fragment;

void main() {
  vec4 texel = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  fragment = vec4(min(factor * texel.xyz, vec3(most)), texel.w);
}
