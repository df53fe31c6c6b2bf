// Stands for a 2D map on both sides, as smooth_cube.glsl does for a cube: its texels hold their coordinates and level.
// It is half as high as wide.
struct SmoothMap {
  float size;  // width
};

FN vec4 sampleMap(SmoothMap map, vec2 uv) { return vec4(uv, map.size, 1.0f); }

FN ivec2 mapSize(SmoothMap map, int level) { return ivec2(int(map.size), int(map.size) / 2) >> level; }

FN vec4 fetchMap(SmoothMap map, ivec2 texel, int level) {
  return vec4(vec2(texel) / map.size, float(level), 1.0f);
}
