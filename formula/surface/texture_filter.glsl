// How a map is read between its texels, beyond its edges and between its mip levels: what texture() does in hardware
// (OpenGL 4.6, section 8.14), for maps that give single texels only.
// Needs: texture_wrap.

struct MapSampling {
  int wrap_s;
  int wrap_t;
  bool magnify_nearest;  // texels larger than pixels show as squares
};

FN vec4 wrappedFetch(MAP_SAMPLER map, vec2 texel, int level, MapSampling sampling) {
  vec2 size = vec2(mapSize(map, level));
  float x = wrappedTexel(texel.x, size.x, sampling.wrap_s);
  float y = wrappedTexel(texel.y, size.y, sampling.wrap_t);
  return fetchMap(map, ivec2(int(x), int(y)), level);
}

FN vec4 nearestTexel(MAP_SAMPLER map, vec2 uv, int level, MapSampling sampling) {
  return wrappedFetch(map, floor(uv * vec2(mapSize(map, level))), level, sampling);
}

FN vec4 bilinearTexels(MAP_SAMPLER map, vec2 uv, int level, MapSampling sampling) {
  vec2 place = uv * vec2(mapSize(map, level)) - vec2(0.5f);
  vec2 first = floor(place);
  vec2 part = place - first;
  vec4 top = mix(wrappedFetch(map, first, level, sampling),
                 wrappedFetch(map, first + vec2(1.0f, 0.0f), level, sampling), part.x);
  vec4 bottom = mix(wrappedFetch(map, first + vec2(0.0f, 1.0f), level, sampling),
                    wrappedFetch(map, first + vec2(1.0f, 1.0f), level, sampling), part.x);
  return mix(top, bottom, part.y);
}

// The mip level whose texels are as large as a pixel, not below 0.
//
// across, down   by how many texels of level 0 the place changes to the next pixel
FN float lodOfTexels(vec2 across, vec2 down) { return log2(max(max(length(across), length(down)), 1.0f)); }

// Trilinear.
//
// lod   from 0 to the map's last level
FN vec4 filteredMap(MAP_SAMPLER map, vec2 uv, float lod, MapSampling sampling) {
  if (lod <= 0.0f && sampling.magnify_nearest) return nearestTexel(map, uv, 0, sampling);
  float level = floor(lod);
  vec4 texels = bilinearTexels(map, uv, int(level), sampling);
  if (lod == level) return texels;
  return mix(texels, bilinearTexels(map, uv, int(level) + 1, sampling), lod - level);
}
