// One face of a cube without its points of light.
#include "bright_light.glsl"
#include "cube.glsl"

uniform samplerCube cube;
uniform int size;
uniform int face;
uniform sampler2D chosen;

out vec4 fragment;

void main() {
  vec3 light = sampleLod(cube, cubePoint(face, gl_FragCoord.xy / float(size)), 0.0).xyz;
  fragment = vec4(light - lightAbove(light, texelFetch(chosen, ivec2(0), 0).x), 1.0);
}
