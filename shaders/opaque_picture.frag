// A picture of opaque surfaces with how near they are, as shaders/surface/behind_screen.glsl reads it.
uniform highp sampler2D picture;
uniform highp sampler2D depths;  // 1: nothing is there
uniform mat4 eye_from_texels;
uniform float unit;

out vec4 fragment;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depths, texel, 0).x;
  vec4 place = eye_from_texels * vec4(gl_FragCoord.xy, depth, 1.0);
  float nearness = depth < 1.0 ? unit * place.w / length(place.xyz) : 0.0;
  const float kLargestHalf = 65504.0;
  fragment = vec4(min(texelFetch(picture, texel, 0).xyz, vec3(kLargestHalf)), nearness);
}
