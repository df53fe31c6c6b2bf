// Part "point" (point_raster.glsl). Here: where the ray meets the relief in the prism below a triangle, exactly.
#include "surface_point.glsl"
#include "relief_look.glsl"
#include "prism.glsl"

in vec3 world_position;  // of the box around the prism: where the ray leaves it
flat in int prism;

vec3 relief_place;  // of the point that was found: on the map in texels, and its height
SurfaceChange relief_change;

SurfacePoint pointOfPrism(vec3 q, vec3 world, vec3 ray) {
  vec3 shares = vec3(1.0 - q.x - q.y, q.x, q.y);
  vec3 position = vec3(0.0);
  vec3 normal = vec3(0.0);
  vec4 uvs = vec4(0.0);
  vec4 tangent = vec4(0.0);
  vec4 color = vec4(0.0);
  float side = 1.0;
  for (int i = 0; i < 3; ++i) {
    int first = texelOfCorner(prism, i);
    PrismCorner corner = cornerOfPrism(prism, i);
    float share = shares[i];
    position += share * corner.position;
    normal += share * corner.normal;
    uvs += share * vec4(corner.uv_0, uintBitsToFloat(fetchWords(prisms, first + 2)).xy);
    vec4 own = uintBitsToFloat(fetchWords(prisms, first + 3));
    tangent += share * own;
    side = own.w;
    color += share * uintBitsToFloat(fetchWords(prisms, first + 4));
  }
  return SurfacePoint(world, position, normalize(normal_matrix * normal), normalize(normal),
                      vec4(mat3(world_from_object) * tangent.xyz, side), uvs.xy, uvs.zw, color, ray);
}

SurfacePoint surfacePoint() {
  PrismCorner a = cornerOfPrism(prism, 0);
  PrismCorner b = cornerOfPrism(prism, 1);
  PrismCorner c = cornerOfPrism(prism, 2);
  ReliefPrism p = prismOf(a, b, c, heightMapSize(), joinedSides(prism));
  bool is_parallel = orthographic > 0.5;
  vec3 ray = is_parallel ? camera_forward : normalize(world_position - camera_position);
  vec3 eye = is_parallel ? world_position - camera_forward * dot(world_position - camera_position, camera_forward)
                         : camera_position;
  vec2 passed = wayThroughBox(boxOfPrism(p), eye, ray);
  ReliefHit hit = hitOfPrism(heights, heightMap(), p, eye, ray, max(passed.x, 0.0), passed.y);
  bool is_met = hit.distance >= 0.0;
  // Where nothing is met, the neighbouring pixels still ask for differences.
  if (!is_met) hit = ReliefHit(passed.y, coordinatesInPrism(p, eye + passed.y * ray, vec3(0.33, 0.33, 0.5)));
  relief_place = onHeightMap(p, hit.coordinates);
  relief_change = changeOf(p.along_x, p.along_y, b.uv_0 - a.uv_0, c.uv_0 - a.uv_0);
  SurfacePoint point = pointOfPrism(hit.coordinates, eye + hit.distance * ray, ray);
  if (!is_met) discard;
  return point;
}

SurfaceChange surfaceChange() { return relief_change; }

void setDepth(SurfacePoint point) { setDepthOf(point.position); }

float lightThatArrives(SurfacePoint point, vec3 towards) {
  return lightOverRelief(point, relief_change, relief_place, towards);
}

bool seesFront() { return true; }
