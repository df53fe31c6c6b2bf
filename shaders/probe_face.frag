// A face of a captured cube from a picture of it: a cubeFaceCamera draws its rows as a texture keeps them.
uniform sampler2D picture;
uniform float factor;
uniform float most;

out vec4 fragment;

void main() {
  vec3 light = factor * texelFetch(picture, ivec2(gl_FragCoord.xy), 0).xyz;
  fragment = vec4(min(light, vec3(most)), 1.0);
}
