// One face of a cube as it is, or without the points of light.
#include "bright_light.glsl"
#include "cube.glsl"

uniform samplerCube cube;
uniform int size;
uniform int face;
uniform bool without_points;
uniform sampler2D chosen;

out vec4 fragment;

void main() {
  vec3 light = sampleLod(cube, cubePoint(face, gl_FragCoord.xy / float(size)), 0.0).xyz;
  if (without_points) light -= lightAbove(light, texelFetch(chosen, ivec2(0), 0).x);
  fragment = vec4(light, 1.0);
}
