// A cube map looked up without a cube sampler: which face, which place on it, and which texels of one picture in which
// the six faces lie side by side, 3 × 2: +X −X +Y above −Y +Z −Z (the layout 3x2), each with its row 0 first. Its mip
// levels are those of the faces.
// Needs: cube.

// Of a face at a level. Asked for level 0, since Mesa's llvmpipe takes the level of one pixel for those beside it.
FN int flatSize(MAP_SAMPLER map, int level) { return max((mapSize(map, 0).y / 2) >> level, 1); }

// The texel of a face; beyond its edge the last one before it, since what lies there in the picture is another part of
// the world.
FN vec4 flatTexel(MAP_SAMPLER map, int face, ivec2 texel, int level) {
  int size = flatSize(map, level);
  ivec2 within = clamp(texel, ivec2(0, 0), ivec2(size - 1, size - 1));
  return fetchMap(map, ivec2(face % 3, face / 3) * size + within, level);
}

FN vec4 flatNearest(MAP_SAMPLER map, vec3 d, int level) {
  int face = cubeFace(d);
  vec2 place = cubeCoordinates(face, d) * float(flatSize(map, level));
  return flatTexel(map, face, ivec2(floor(place)), level);
}

// The four texels around the place, weighed by how near their centres are.
FN vec4 flatBilinear(MAP_SAMPLER map, vec3 d, int level) {
  int face = cubeFace(d);
  vec2 place = cubeCoordinates(face, d) * float(flatSize(map, level)) - vec2(0.5f, 0.5f);
  vec2 part = place - floor(place);
  ivec2 first = ivec2(floor(place));
  vec4 upper = mix(flatTexel(map, face, first, level), flatTexel(map, face, first + ivec2(1, 0), level), part.x);
  vec4 lower =
      mix(flatTexel(map, face, first + ivec2(0, 1), level), flatTexel(map, face, first + ivec2(1, 1), level), part.x);
  return mix(upper, lower, part.y);
}

// The last mip level, of one texel a face.
FN float flatLastLevel(MAP_SAMPLER map) { return floor(log2(float(flatSize(map, 0))) + 1e-3f); }

// The nearest texel of the nearest level, as GL_NEAREST_MIPMAP_NEAREST has it.
FN vec4 flatNearestLod(MAP_SAMPLER map, vec3 d, float lod) {
  return flatNearest(map, d, int(clamp(lod, 0.0f, flatLastLevel(map)) + 0.5f));
}

// Between the texels and between the levels, as GL_LINEAR_MIPMAP_LINEAR has it, but for the edges of faces.
FN vec4 flatTrilinear(MAP_SAMPLER map, vec3 d, float lod) {
  float within = clamp(lod, 0.0f, flatLastLevel(map));
  int level = int(within);
  vec4 fine = flatBilinear(map, d, level);
  float coarser = within - float(level);
  if (coarser == 0.0f) return fine;
  return mix(fine, flatBilinear(map, d, level + 1), coarser);
}
