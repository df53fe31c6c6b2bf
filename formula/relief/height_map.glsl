// A map of heights between 0 and 1, whose surface is the one that bilinear filtering shows: a patch between each four
// centres of texels. The picture that holds it has the heights in x and cones in y (height_field/cone_map.h) from texel
// (0, 0) on, and beside or below them levels of maxima (height_field/maximum_pyramid.h), each where placeOfLevel says:
// not in mip levels, since drivers may read one level for four pixels.
// Places on the map are counted in texels; the centre of the first one is (0, 0). Needs: texture_wrap.

struct HeightMap {
  vec2 size;       // texels
  int wrap;        // kWrapRepeat or kWrapClampToEdge
  int last_level;  // the one that is a single cell
};

FN ivec2 sizeOfLevel(HeightMap map, int level) { return max(ivec2(map.size) >> level, ivec2(1)); }

// Where a level begins in the picture. From level 1 on they lie along the longer side.
FN ivec2 placeOfLevel(HeightMap map, int level) {
  ivec2 size = ivec2(map.size);
  if (level == 0) return ivec2(0);
  return size.y >= size.x ? ivec2(size.x, size.y - (size.y >> (level - 1)))
                          : ivec2(size.x - (size.x >> (level - 1)), size.y);
}

FN vec2 placeOnMap(vec2 uv, vec2 size) { return uv * size - vec2(0.5f); }

FN vec2 heightTexel(MAP_SAMPLER heights, HeightMap map, vec2 texel) {
  vec2 wrapped = vec2(wrappedTexel(texel.x, map.size.x, map.wrap), wrappedTexel(texel.y, map.size.y, map.wrap));
  vec4 stored = fetchMap(heights, ivec2(wrapped), 0);
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

// How it grows a texel along u and along v.
FN vec2 slopeOfPatch(vec4 corners, vec2 part) {
  return vec2(mix(corners.y - corners.x, corners.w - corners.z, part.y),
              mix(corners.z - corners.x, corners.w - corners.y, part.x));
}

//   place   in texels
FN float heightAt(MAP_SAMPLER heights, HeightMap map, vec2 place) {
  vec2 first = floor(place);
  return heightOfPatch(patchCorners(heights, map, first), place - first);
}
