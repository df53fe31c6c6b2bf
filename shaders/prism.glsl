// The prisms of a mesh's relief as a list of texels (scene/relief/prism_list.h): five for each corner of a
// triangle, and one of its sides and heights.
#include "box.glsl"
#include "relief_prism.glsl"

uniform highp usampler2D prisms;

const int kTexelsOfCorner = 5;
const int kTexelsOfPrism = 16;

struct PrismCorner {
  vec3 position;  // object
  vec3 normal;    // object
  vec2 uv_0;
};

int texelOfCorner(int prism, int corner) { return prism * kTexelsOfPrism + corner * kTexelsOfCorner; }

PrismCorner cornerOfPrism(int prism, int corner) {
  int first = texelOfCorner(prism, corner);
  vec4 a = uintBitsToFloat(fetchWords(prisms, first));
  vec4 b = uintBitsToFloat(fetchWords(prisms, first + 1));
  return PrismCorner(a.xyz, b.xyz, vec2(a.w, b.w));
}

// In the world.
//   depth      of the relief, in the object's space
//   map_size   texels of the map, of which `tiles` lie on a unit of texture coordinate
ReliefPrism prismOf(int prism, mat4 world_from_object, float depth, float tiles, vec2 map_size) {
  PrismCorner a = cornerOfPrism(prism, 0);
  PrismCorner b = cornerOfPrism(prism, 1);
  PrismCorner c = cornerOfPrism(prism, 2);
  mat3 turn = mat3(world_from_object);
  vec2 texels = tiles * map_size;
  uvec4 last = fetchWords(prisms, prism * kTexelsOfPrism + 15);
  return ReliefPrism((world_from_object * vec4(a.position, 1.0)).xyz, turn * (b.position - a.position),
                     turn * (c.position - a.position), turn * (depth * a.normal),
                     turn * (depth * (b.normal - a.normal)), turn * (depth * (c.normal - a.normal)),
                     placeOnMap(a.uv_0 * tiles, map_size), (b.uv_0 - a.uv_0) * texels, (c.uv_0 - a.uv_0) * texels,
                     uintBitsToFloat(last).xyz, unpackUnorm2x16(last.w));
}
