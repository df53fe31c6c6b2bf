#include "mirrorball/light_edit/map_texel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/light_edit/map_lamp.h"

namespace mirrorball {
namespace {

constexpr int kTile = 16;  // texels a side

glm::dvec3 directionOfPlace(const EnvironmentMap& map, int face, glm::vec2 position) {
  return glm::normalize(glm::dvec3(directionAt(map.projection(), {face, position / glm::vec2(map.extent())})));
}

}  // namespace

bool hasKnownNeighbours(Projection projection) {
  return projection == Projection::equirect || faceCount(projection) == 6;
}

MapTexel texelBeside(const EnvironmentMap& map, const MapTexel& texel, glm::ivec2 step) {
  const glm::ivec2 extent = map.extent();
  glm::ivec2 place = texel.place + step;
  if (map.projection() == Projection::equirect) {
    // Beyond a pole the row goes on at the opposite meridian.
    if (place.y < 0 || place.y >= extent.y) place = {place.x + extent.x / 2, texel.place.y};
    return {texel.face, {(place.x + extent.x) % extent.x, place.y}};
  }
  if (std::min(place.x, place.y) >= 0 && std::max(place.x, place.y) < extent.x) return {texel.face, place};
  const glm::vec3 direction = directionOfPlace(map, texel.face, glm::vec2(place) + 0.5f);
  const MapPosition found = positionOf(map.projection(), direction);
  return {found.face, glm::clamp(glm::ivec2(found.uv * glm::vec2(extent)), glm::ivec2(0), extent - 1)};
}

glm::dvec3 directionOf(const EnvironmentMap& map, const MapTexel& texel) {
  return directionOfPlace(map, texel.face, glm::vec2(texel.place) + 0.5f);
}

glm::vec3 radianceOf(const EnvironmentMap& map, const MapTexel& texel) {
  return rgbAt(map.face(texel.face), texel.place.x, texel.place.y);
}

float texelWidth_rad(const EnvironmentMap& map) { return 1.0f / texelDensity(map.projection(), map.size()); }

void forEachTexelNear(const EnvironmentMap& map, glm::vec3 direction, float angle_rad,
                      const std::function<void(const MapTexel&, glm::dvec3)>& visit) {
  const glm::ivec2 extent = map.extent();
  const glm::dvec3 middle = glm::normalize(glm::dvec3(direction));
  // No texel of a tile is farther from the tile's middle than half of its diagonal.
  const double half_tile = std::numbers::sqrt2 / 2.0 * kTile * double(texelWidth_rad(map));
  for (int face = 0; face < map.faces(); ++face)
    for (int top = 0; top < extent.y; top += kTile)
      for (int left = 0; left < extent.x; left += kTile) {
        const glm::vec2 middle_of_tile = glm::vec2(left, top) + float(kTile) / 2.0f;
        const glm::dvec3 towards = directionOfPlace(map, face, glm::min(middle_of_tile, glm::vec2(extent)));
        if (angleBetween(towards, middle) > double(angle_rad) + half_tile) continue;
        for (int y = top; y < std::min(top + kTile, extent.y); ++y)
          for (int x = left; x < std::min(left + kTile, extent.x); ++x) {
            const glm::dvec3 of_texel = directionOf(map, {face, {x, y}});
            if (angleBetween(of_texel, middle) < double(angle_rad)) visit({face, {x, y}}, of_texel);
          }
      }
}

}  // namespace mirrorball
