// One sample's share of the mean over all samples of a pixel.
uniform sampler2D picture;
uniform float share;

out vec4 fragment;

void main() { fragment = texelFetch(picture, ivec2(gl_FragCoord.xy), 0) * share; }
