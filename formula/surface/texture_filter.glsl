// How a map is read between its texels, beyond its edges and between its mip levels: what texture() does in hardware
// (OpenGL 4.6, section 8.14), for maps that give single texels only.
// Needs: filter_kind, texture_wrap.

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

// As wide as a pixel: filter_kind.glsl.
//
// across, down   how uv changes to the next pixels
// last_level     of the map
FN vec4 mapInPixel(MAP_SAMPLER map, vec2 uv, vec2 across, vec2 down, float last_level, MapSampling sampling, int kind) {
  vec2 size = vec2(mapSize(map, 0));
  float width = length(across * size);
  float height = length(down * size);
  float longer = max(width, height);
  int reads = kind == kFilterAnisotropic ? readsAlong(longer, min(width, height)) : 1;
  float lod = readsMipLevels(kind) ? min(log2(max(longer / float(reads), 1.0f)), last_level) : 0.0f;
  MapSampling how = sampling;
  how.magnify_nearest = kind == kFilterNearest || (sampling.magnify_nearest && longer <= 1.0f);
  vec2 along = width > height ? across : down;
  vec4 sum = vec4(0.0f);
  for (int i = 0; i < reads; ++i) sum += filteredMap(map, uv + placeOfRead(i, reads) * along, lod, how);
  return sum / float(reads);
}
