// Textures for which a material has no unit of their own: layers of one array. Each keeps its size, in the corner of
// its layer at texel (0, 0), and its mip levels. What the hardware does for a texture with a unit of its own is done
// here: wrapping, filtering and decoding.
#include "color.glsl"
#include "filter_kind.glsl"
#include "texture_wrap.glsl"

uniform highp sampler2DArray map_layers;

struct MapLayer {
  int layer;
  vec3 extent;  // width, height, last mip level
  bool srgb;
};

ivec2 mapSize(MapLayer map, int level) { return max(ivec2(map.extent.xy) >> level, ivec2(1)); }

vec4 fetchMap(MapLayer map, ivec2 texel, int level) {
  vec4 stored = texelFetch(map_layers, ivec3(texel, map.layer), level);
  return map.srgb ? vec4(linearFromSrgb(stored.xyz), stored.w) : stored;
}

// To the formulas of filtering a map is a layer; to those that are included later, a sampler again.
#undef MAP_SAMPLER
#define MAP_SAMPLER MapLayer
#include "texture_filter.glsl"
#undef MAP_SAMPLER
#define MAP_SAMPLER sampler2D

//   across, down   how uv changes over what is seen
vec4 layerAt(MapLayer map, MapSampling sampling, vec2 uv, vec2 across, vec2 down) {
  return mapInPixel(map, uv, across, down, map.extent.z, sampling, TEXTURE_FILTER);
}
