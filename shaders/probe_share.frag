// A share of one face of a level of a cube.
#include "cube.glsl"

uniform samplerCube cube;
uniform float level;
uniform float share;
uniform int size;
uniform int face;

out vec4 fragment;

void main() {
  fragment = share * vec4(sampleLod(cube, cubePoint(face, gl_FragCoord.xy / float(size)), level).xyz, 1.0);
}
