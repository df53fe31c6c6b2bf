#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/light_edit/lamp_search.h"
#include "mirrorball/light_edit/map_texel.h"

namespace mirrorball::testing {

/// Where maps have seams: near the middle of a face, at the seam of panoramas, at poles, an edge and a corner of cubes;
/// and a place without.
inline const std::array<glm::vec3, 7> kPlaces{{{0.0f, 0.02f, 1.0f},
                                               {0.0f, 0.0f, -1.0f},
                                               {0.0f, 1.0f, 0.0f},
                                               {0.0f, -1.0f, 0.0f},
                                               {1.0f, 0.03f, 1.0f},
                                               {-1.0f, 1.0f, -1.0f},
                                               {0.3f, 0.8f, -0.5f}}};

/// A disc in a sky.
struct MadeSun {
  glm::vec3 direction{0.0f};  ///< of any length
  float size_deg = 0.5f;      ///< its diameter
  glm::vec3 radiance{1e5f};

  float solidAngle_sr() const {
    const float sine = std::sin(glm::radians(size_deg) / 4.0f);
    return 4.0f * 3.14159265f * sine * sine;
  }
  glm::vec3 irradiance() const { return radiance * solidAngle_sr(); }
};

using MadeSky = std::function<glm::vec3(glm::vec3)>;

/// Light that changes slowly, in another colour everywhere: about 1.
inline glm::vec3 smoothSky(glm::vec3 d) { return {0.8f + 0.2f * d.x, 0.9f + 0.2f * d.y, 1.1f + 0.3f * d.y}; }

/// Clouds as large as a few degrees, from half as bright to twice as bright as the smooth sky.
inline glm::vec3 cloudySky(glm::vec3 d) {
  const float waves = std::sin(31.0f * d.x + 2.0f) * std::sin(37.0f * d.y) + std::sin(29.0f * d.z + 11.0f * d.x);
  return smoothSky(d) * std::exp2(0.5f * waves);
}

/// A map whose texels have a sky's light at their centres.
inline EnvironmentMap mapOfSky(const MadeSky& sky, Projection projection, int size) {
  ImageSet images(1, faceCount(projection));
  const glm::ivec2 extent = imageSize(projection, size);
  for (int face = 0; face < images.faces(); ++face) {
    images.at(0, face) = Image(extent.x, extent.y, 3);
    for (int y = 0; y < extent.y; ++y)
      for (int x = 0; x < extent.x; ++x) {
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / glm::vec2(extent);
        if (!covers(projection, uv)) continue;
        const glm::vec3 light = sky(directionAt(projection, {face, uv}));
        std::copy_n(&light.x, 3, images.at(0, face).texel(x, y));
      }
  }
  return EnvironmentMap(projection, std::move(images));
}

/// How much of a texel a disc covers, by so many points across and down.
inline float coverOf(const MadeSun& sun, const EnvironmentMap& map, const MapTexel& texel, int points) {
  const glm::dvec3 middle = glm::normalize(glm::dvec3(sun.direction));
  int inside = 0;
  for (int y = 0; y < points; ++y)
    for (int x = 0; x < points; ++x) {
      const glm::vec2 place = glm::vec2(texel.place) + (glm::vec2(x, y) + 0.5f) / float(points);
      const glm::vec3 d = directionAt(map.projection(), {texel.face, place / glm::vec2(map.extent())});
      if (2.0 * angleBetween(glm::normalize(glm::dvec3(d)), middle) < double(glm::radians(sun.size_deg))) ++inside;
    }
  return float(inside) / float(points * points);
}

/// Adds a sun: each texel gets the mean over its area, and all together exactly the sun's light.
inline void addSun(const MadeSun& sun, EnvironmentMap& map) {
  const int points = glm::radians(sun.size_deg) < 3.0f * texelWidth_rad(map) ? 24 : 8;
  const glm::vec3 middle = glm::normalize(sun.direction);
  const float reach = glm::radians(sun.size_deg) / 2.0f + 2.0f * texelWidth_rad(map);
  std::vector<std::pair<MapTexel, float>> covers;
  float angle = 0.0f;
  forEachTexelNear(map, middle, reach, [&](const MapTexel& texel, glm::dvec3) {
    covers.emplace_back(texel, coverOf(sun, map, texel, points));
    angle += covers.back().second * texelSolidAngle(map.projection(), map.extent(), texel.place);
  });
  for (const auto& [texel, cover] : covers) {
    const glm::vec3 light = sun.radiance * (cover * sun.solidAngle_sr() / angle);
    for (int c = 0; c < 3; ++c) map.face(texel.face).texel(texel.place.x, texel.place.y)[c] += light[c];
  }
}

inline EnvironmentMap mapOfSuns(const std::vector<MadeSun>& suns, const MadeSky& sky, Projection projection, int size) {
  EnvironmentMap map = mapOfSky(sky, projection, size);
  for (const MadeSun& sun : suns) addSun(sun, map);
  return map;
}

/// Its lamps.
inline std::vector<MapLamp> lampsIn(const EnvironmentMap& map, const LampSettings& settings = {}) {
  return findLamps(map, wholeLight(map), settings);
}

}  // namespace mirrorball::testing
