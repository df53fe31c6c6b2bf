// The numbers of the material that is drawn, and where each of its maps (mapNumber, in the order of materialMaps) lies.
#include "material.glsl"

layout(std140) uniform MaterialBlock {
  Material material;
  vec4 map_matrix[MAP_COUNT];  // columns of a 2 × 2 matrix
  vec4 map_offset[MAP_COUNT];  // x, y; z: which set of texture coordinates
};
