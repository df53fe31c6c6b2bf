// Stands for a 2D map on both sides, as smooth_cube.glsl does for a cube: its texels hold their coordinates.
struct SmoothMap {
  float size;
};

FN vec4 sampleMap(SmoothMap map, vec2 uv) { return vec4(uv, map.size, 1.0f); }

FN vec2 mapSize(SmoothMap map) { return vec2(map.size); }
