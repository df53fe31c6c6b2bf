// Part "point" (point_raster.glsl). Here: where the ray meets the relief below a triangle, exactly. Which one and where
// was found before (shaders/relief_hits.frag).
#include "surface_point.glsl"
#include "relief_look.glsl"
#include "prism.glsl"

uniform highp sampler2D relief_hits;

vec3 relief_place;  // of the point that was found: on the map in texels, and its height
SurfaceChange relief_change;

// A way through a pixel, of any length.
struct PixelWay {
  vec3 from;
  vec3 along;
};

PixelWay wayThrough(vec2 pixel) {
  vec2 clip = 2.0 * pixel / vec2(textureSize(relief_hits, 0)) - 1.0;
  vec4 near = world_from_clip * vec4(clip, -1.0, 1.0);
  vec4 beyond = world_from_clip * vec4(clip, 0.0, 1.0);
  vec3 from = near.xyz / near.w;
  return PixelWay(from, beyond.xyz / beyond.w - from);
}

// How a place changes to the next pixel, on the plane across n. The places that those have met may be elsewhere.
vec3 changeOnPlane(vec3 place, vec3 n, PixelWay here, PixelWay next) {
  float closing = dot(n, here.along);
  float least = 1e-3 * length(here.along);
  if (abs(closing) < least) closing = closing < 0.0 ? -least : least;
  vec3 change = next.from - here.from + dot(n, place - here.from) / closing * (next.along - here.along);
  return change - here.along * (dot(n, change) / closing);
}

// What is interpolated over a triangle.
//   shares   of the corners
SurfacePoint pointOfPrism(int prism, vec3 shares, vec3 world) {
  vec3 position = vec3(0.0);
  vec3 normal = vec3(0.0);
  vec4 uvs = vec4(0.0);
  vec4 tangent = vec4(0.0);
  vec4 color = vec4(0.0);
  float side = 1.0;
  for (int i = 0; i < 3; ++i) {
    int first = texelOfCorner(prism, i);
    PrismCorner corner = cornerOfPrism(prism, i);
    position += shares[i] * corner.position;
    normal += shares[i] * corner.normal;
    uvs += shares[i] * vec4(corner.uv_0, uintBitsToFloat(fetchWords(prisms, first + 2)).xy);
    vec4 own = uintBitsToFloat(fetchWords(prisms, first + 3));
    tangent += shares[i] * own;
    side = own.w;
    color += shares[i] * uintBitsToFloat(fetchWords(prisms, first + 4));
  }
  vec3 n = normalize(normal_matrix * normal);
  vec3 ray = orthographic > 0.5 ? camera_forward : normalize(world - camera_position);
  PixelWay here = wayThrough(gl_FragCoord.xy);
  vec3 across = changeOnPlane(world, n, here, wayThrough(gl_FragCoord.xy + vec2(1.0, 0.0)));
  vec3 down = changeOnPlane(world, n, here, wayThrough(gl_FragCoord.xy + vec2(0.0, 1.0)));
  vec2 uv_across = uvAlong(relief_change, n, across);
  vec2 uv_down = uvAlong(relief_change, n, down);
  return SurfacePoint(world, position, n, normalize(normal), vec4(mat3(world_from_object) * tangent.xyz, side), uvs.xy,
                      uvs.zw, color, ray, uv_across, uv_down, uv_across, uv_down, vec3(0.0), vec3(0.0));
}

SurfacePoint surfacePoint() {
  vec4 found = texelFetch(relief_hits, ivec2(gl_FragCoord.xy), 0);
  if (found.w != float(instance + 1)) discard;
  int prism = int(found.x);
  ReliefPrism p = prismOf(prism, world_from_object, abs(material.height_scale), material.height_frequency,
                          heightMapSize());
  relief_place = onHeightMap(p, vec3(found.yz, 0.0));
  relief_place.z = heightAt(heights, heightMap(), relief_place.xy);
  vec2 tiles = material.height_frequency * heightMapSize();
  relief_change = changeOf(p.along_x, p.along_y, p.texel_along_x / tiles, p.texel_along_y / tiles);
  SurfacePoint point = pointOfPrism(prism, vec3(1.0 - found.y - found.z, found.y, found.z),
                                    placeInPrism(p, vec3(found.yz, relief_place.z)));
  seeRelief(point, relief_change);
  return point;
}

SurfaceChange surfaceChange() { return relief_change; }

void setDepth(SurfacePoint point) { setDepthOf(point.position); }

float lightThatArrives(SurfacePoint point, vec3 towards) {
  return lightOverRelief(point, relief_change, relief_place, towards);
}

vec3 placeAboveRelief(SurfacePoint point, vec3 towards) { return placeOnMesh(point, relief_place.z, towards); }

bool seesFront() { return true; }

float iorAroundVertices() { return 1.0; }
