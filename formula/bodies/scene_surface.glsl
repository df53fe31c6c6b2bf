// What reflections show of a scene where a ray meets it: in a tree of its triangles (scene/bodies/body_tree.cpp) that
// has two more parts, which the last words of its texels 1 and 2 give the first texels of:
//   of a triangle  one texel: the numbers of its corners
//   of a vertex    two texels of half floats: hidden, open, shown, metallic; base colour, roughness, emission, 0
// Needs: triangle_tree.

const int kTexelsOfVertex = 2;

struct SceneSurface {
  vec3 normal;            // unit, outwards, interpolated
  vec3 geometric_normal;  // unit, of the triangle
  vec4 hidden;            // and the share that is open, as VertexOcclusion has them
  vec3 shown;
  float metallic;
  vec3 base_color;
  float perceptual_roughness;
  vec3 emission;
};

FN vec4 halvesOf(uint a, uint b) { return vec4(unpackHalf2x16(a), unpackHalf2x16(b)); }

FN SceneSurface sceneSurfaceAt(WORD_SAMPLER tree, TriangleHit hit) {
  BodySurface surface = bodySurfaceAt(tree, hit);
  uvec4 corners = fetchWords(tree, int(fetchWords(tree, 1).w) + hit.triangle);
  int first = int(fetchWords(tree, 2).w);
  vec4 hidden = vec4(0.0f);
  vec4 shown = vec4(0.0f);
  vec4 color = vec4(0.0f);
  vec4 emission = vec4(0.0f);
  for (int i = 0; i < 3; ++i) {
    int vertex = int(i == 0 ? corners.x : (i == 1 ? corners.y : corners.z));
    float weight = i == 0 ? 1.0f - hit.barycentric.x - hit.barycentric.y
                          : (i == 1 ? hit.barycentric.x : hit.barycentric.y);
    uvec4 occlusion = fetchWords(tree, first + vertex * kTexelsOfVertex);
    uvec4 look = fetchWords(tree, first + vertex * kTexelsOfVertex + 1);
    hidden += weight * halvesOf(occlusion.x, occlusion.y);
    shown += weight * halvesOf(occlusion.z, occlusion.w);
    color += weight * halvesOf(look.x, look.y);
    emission += weight * halvesOf(look.z, look.w);
  }
  return MAKE(SceneSurface)(surface.normal, surface.geometric_normal, hidden, vec3(shown), shown.w, vec3(color),
                            color.w, vec3(emission));
}
