// One face of a cube as it is.
#include "cube.glsl"

uniform samplerCube cube;
uniform int size;
uniform int face;

out vec4 fragment;

void main() { fragment = vec4(sampleLod(cube, cubePoint(face, gl_FragCoord.xy / float(size)), 0.0).xyz, 1.0); }
