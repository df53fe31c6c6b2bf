// A map of heights between 0 and 1, whose surface is the one that bilinear filtering shows: a patch between each four
// centres of texels. Level 0 holds the heights in x and cones in y (height_field/cone_map.h), each level from 1 on the
// maxima of the patches below it (height_field/maximum_pyramid.h).
// Places on the map are counted in texels; the centre of the first one is (0, 0). Needs: texture_filter.

struct HeightMap {
  int wrap;        // kWrapRepeat or kWrapClampToEdge
  int last_level;  // the one that is a single cell
};

FN vec2 placeOnMap(vec2 uv, vec2 size) { return uv * size - vec2(0.5f); }

FN vec2 heightTexel(MAP_SAMPLER heights, HeightMap map, vec2 texel) {
  vec4 stored = wrappedFetch(heights, texel, 0, MapSampling(map.wrap, map.wrap, false));
  return vec2(stored.x, stored.y);
}

// The heights at the corners of a patch: at (0, 0), (1, 0), (0, 1) and (1, 1).
FN vec4 patchCorners(MAP_SAMPLER heights, HeightMap map, vec2 first) {
  return vec4(heightTexel(heights, map, first).x, heightTexel(heights, map, first + vec2(1.0f, 0.0f)).x,
              heightTexel(heights, map, first + vec2(0.0f, 1.0f)).x,
              heightTexel(heights, map, first + vec2(1.0f, 1.0f)).x);
}

//   part    of the patch, in [0, 1]
FN float heightOfPatch(vec4 corners, vec2 part) {
  return mix(mix(corners.x, corners.y, part.x), mix(corners.z, corners.w, part.x), part.y);
}

//   place   in texels
FN float heightAt(MAP_SAMPLER heights, HeightMap map, vec2 place) {
  vec2 first = floor(place);
  return heightOfPatch(patchCorners(heights, map, first), place - first);
}
