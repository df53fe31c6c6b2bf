// Light from cube maps that lie flat in pictures (formula/projection/flat_cube.glsl). FLAT_LOOK_UP names the formula.
#include "cube.glsl"
#include "filter_kind.glsl"

uniform highp sampler2D environment_faces;
uniform highp sampler2D prefiltered_faces;
uniform highp sampler2D irradiance_faces;

// Samplers can be no constants: a number says which of them is meant.
struct FlatCube {
  int number;
};
const FlatCube environment = FlatCube(0);
const FlatCube prefiltered = FlatCube(1);
const FlatCube irradiance = FlatCube(2);

ivec2 mapSize(FlatCube map, int level) {
  if (map.number == 0) return textureSize(environment_faces, level);
  if (map.number == 1) return textureSize(prefiltered_faces, level);
  return textureSize(irradiance_faces, level);
}

vec4 fetchMap(FlatCube map, ivec2 texel, int level) {
  if (map.number == 0) return texelFetch(environment_faces, texel, level);
  if (map.number == 1) return texelFetch(prefiltered_faces, texel, level);
  return texelFetch(irradiance_faces, texel, level);
}

// To the formulas of the look-up a flat cube is a map; to those of the light, a cube.
#undef MAP_SAMPLER
#define MAP_SAMPLER FlatCube
#include "flat_cube.glsl"
#undef MAP_SAMPLER
#define MAP_SAMPLER sampler2D

vec4 sampleLod(FlatCube map, vec3 d, float lod) {
  if (TEXTURE_FILTER == kFilterNearest && map.number == 0 && lod <= 0.0) return flatNearest(map, d, 0);
  return FLAT_LOOK_UP(map, d, lod);
}

#undef CUBE_SAMPLER
#define CUBE_SAMPLER FlatCube
#include "distant_light.glsl"
#undef CUBE_SAMPLER
#define CUBE_SAMPLER samplerCube
