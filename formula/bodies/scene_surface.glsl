// What reflections show of a scene where a ray meets it: in a tree of its triangles (scene/bodies/body_tree.cpp) that
// has two more parts, which the last words of its texels 1 and 2 give the first texels of:
//   of a triangle  one texel: the numbers of its corners, the first with its highest bit set where what their backs
//                  know follows each of them, the second where it has only a front; the texel of its holes, or 0
//   of a vertex    three texels of half floats: occluded, open, interreflected, metallic; base colour, roughness,
//                  emission, 0; lit_from, 0, emitted, 0
// and further on, for some triangles, their holes: a texel with the number of rows of their cells, and then a bit for
// each cell, 1 where it is cut away.
// Needs: triangle_tree.

const int kTexelsOfVertex = 3;

struct SceneSurface {
  vec3 normal;            // unit, outwards, interpolated
  vec3 geometric_normal;  // unit, of the triangle
  vec4 occluded;          // and the share that is open, as VertexOcclusion has them, of the side that is met
  vec3 interreflected;
  vec3 lit_from;
  vec3 emitted;
  float metallic;
  vec3 base_color;
  float perceptual_roughness;
  vec3 emission;
};

// The cell of a place in a triangle that is cut into rows² alike triangles, those of a row by the first coordinate one
// after the other.
FN int cellOfTriangle(vec2 barycentric, int rows) {
  vec2 place = max(barycentric, vec2(0.0f)) * float(rows);
  int row = min(int(place.x), rows - 1);
  int column = min(int(place.y), rows - 1 - row);
  bool is_second = place.x - float(row) + place.y - float(column) > 1.0f && row + column < rows - 1;
  return row * (2 * rows - row) + 2 * column + (is_second ? 1 : 0);
}

// Whether a ray meets a triangle from its clockwise side.
FN bool isMetFromBehind(WORD_SAMPLER tree, TriangleHit hit, vec3 direction) {
  int texel = int(fetchWords(tree, 0).y) + hit.triangle * kTexelsOfTriangle;
  vec3 corner = floatsOf(fetchWords(tree, texel));
  return dot(direction, cross(normalize(floatsOf(fetchWords(tree, texel + 1)) - corner),
                              normalize(floatsOf(fetchWords(tree, texel + 2)) - corner))) > 0.0f;
}

// Whether a ray goes on where it meets a triangle: that is cut away there, or has only a front and is met from behind.
FN bool passesTriangle(WORD_SAMPLER tree, TriangleHit hit, vec3 direction) {
  uvec4 corners = fetchWords(tree, int(fetchWords(tree, 1).w) + hit.triangle);
  if (corners.y >> 31 != 0u && isMetFromBehind(tree, hit, direction)) return true;
  int texel = int(corners.w);
  if (texel == 0) return false;
  int cell = cellOfTriangle(hit.barycentric, int(fetchWords(tree, texel).x));
  uvec4 holes = fetchWords(tree, texel + 1 + cell / 128);
  int word = cell / 32 % 4;
  uint bits = word < 2 ? (word == 0 ? holes.x : holes.y) : (word == 2 ? holes.z : holes.w);
  return (bits >> uint(cell % 32) & 1u) != 0u;
}

// Of finite half floats, as unpackHalf2x16 does, which is six times the work for drivers that write it out: their bits
// as those of a float are that number times 2^−112. Where floats below 1e-38 count as 0, so do halves below 6e-5.
FN vec4 halvesOf(uint a, uint b) {
  const float kPowerOfTwo = 5.192296858534828e33f;  // 2^112
  uvec4 halves = uvec4(a, a >> 16u, b, b >> 16u);
  uvec4 sign = (halves & uvec4(0x8000u)) << 16u;
  uvec4 magnitude = (halves & uvec4(0x7FFFu)) << 13u;
  return uintBitsToFloat(sign | magnitude) * kPowerOfTwo;
}

// Of a back of which nothing is known, all is open.
//   direction  of the ray
FN SceneSurface sceneSurfaceAt(WORD_SAMPLER tree, TriangleHit hit, vec3 direction) {
  BodySurface surface = bodySurfaceAt(tree, hit);
  uvec4 corners = fetchWords(tree, int(fetchWords(tree, 1).w) + hit.triangle);
  bool is_back = dot(direction, surface.geometric_normal) > 0.0f;
  bool knows_backs = corners.x >> 31 != 0u;
  corners &= uvec4(0x7FFFFFFFu);
  int side = is_back && knows_backs ? 1 : 0;
  int first = int(fetchWords(tree, 2).w);
  vec4 occluded = vec4(0.0f);
  vec4 interreflected = vec4(0.0f);
  vec4 color = vec4(0.0f);
  vec4 emission = vec4(0.0f);
  vec4 lit_from = vec4(0.0f);
  vec4 emitted = vec4(0.0f);
  for (int i = 0; i < 3; ++i) {
    int vertex = int(i == 0 ? corners.x : (i == 1 ? corners.y : corners.z)) + side;
    float weight = i == 0 ? 1.0f - hit.barycentric.x - hit.barycentric.y
                          : (i == 1 ? hit.barycentric.x : hit.barycentric.y);
    uvec4 occlusion = fetchWords(tree, first + vertex * kTexelsOfVertex);
    uvec4 material = fetchWords(tree, first + vertex * kTexelsOfVertex + 1);
    occluded += weight * halvesOf(occlusion.x, occlusion.y);
    interreflected += weight * halvesOf(occlusion.z, occlusion.w);
    color += weight * halvesOf(material.x, material.y);
    emission += weight * halvesOf(material.z, material.w);
    uvec4 light = fetchWords(tree, first + vertex * kTexelsOfVertex + 2);
    lit_from += weight * halvesOf(light.x, light.y);
    emitted += weight * halvesOf(light.z, light.w);
  }
  float known = is_back && !knows_backs ? 0.0f : 1.0f;
  occluded = vec4(known * vec3(occluded), mix(1.0f, occluded.w, known));
  return MAKE(SceneSurface)(surface.normal, surface.geometric_normal, occluded, known * vec3(interreflected),
                            known * vec3(lit_from), known * vec3(emitted), interreflected.w, vec3(color), color.w,
                            vec3(emission));
}
