// The list of points of light. Column k is the k-th texel above the threshold: its direction in row 0, what it exceeds
// the threshold by times its solid angle in row 1. The counts of blocks and of their cells lead there without looking
// at every texel (Ziegler et al. 2006, "GPU point list generation through histogram pyramids").
#include "bright_light.glsl"
#include "cube.glsl"

uniform samplerCube cube;
uniform int size;
uniform int cells_across;  // a face
uniform sampler2D cells;
uniform sampler2D blocks;
uniform sampler2D chosen;

out vec4 fragment;

// Goes through the texels of counts from `begin` to before `end` until `rank` of what they count would be passed; takes
// what was passed off the rank.
ivec2 placeOf(sampler2D counts, ivec2 begin, ivec2 end, int channel, inout int rank) {
  for (int y = begin.y; y < end.y; ++y)
    for (int x = begin.x; x < end.x; ++x) {
      int here = int(texelFetch(counts, ivec2(x, y), 0)[channel]);
      if (rank < here) return ivec2(x, y);
      rank -= here;
    }
  return begin;
}

vec4 lightOfCell(ivec2 cell, float threshold, int rank, bool direction_wanted) {
  int face = cell.x / cells_across;
  ivec2 begin = ivec2(cell.x % cells_across, cell.y) * 8;
  ivec2 end = min(begin + 8, ivec2(size));
  for (int y = begin.y; y < end.y; ++y)
    for (int x = begin.x; x < end.x; ++x) {
      vec2 st = (vec2(x, y) + 0.5) / float(size);
      vec3 light = sampleLod(cube, cubePoint(face, st), 0.0).xyz;
      if (brightness(light) <= threshold) continue;
      if (rank == 0)
        return vec4(direction_wanted ? cubeDirection(face, st)
                                     : lightAbove(light, threshold) * cubeTexelSolidAngle(st, float(size)),
                    0.0);
      --rank;
    }
  return vec4(0.0);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 choice = texelFetch(chosen, ivec2(0), 0);
  fragment = vec4(0.0);
  if (pixel.x >= int(choice.z)) return;
  int rank = pixel.x;
  int channel = int(choice.y);
  ivec2 block = placeOf(blocks, ivec2(0), textureSize(blocks, 0), channel, rank) * 8;
  ivec2 cell = placeOf(cells, block, min(block + 8, textureSize(cells, 0)), channel, rank);
  fragment = lightOfCell(cell, choice.x, rank, pixel.y == 0);
}
