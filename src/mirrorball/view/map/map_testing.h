#pragma once

#include <cmath>

#include "mirrorball/environment/convert/map_by_texel.h"
#include "mirrorball/view/map/prepared_map.h"

namespace mirrorball::testing {

/// A map whose texels are a function of their directions.
///
/// projection  one without a disc
template <typename Radiance>
EnvironmentMap mapOf(Projection projection, int size, const Radiance& radiance) {
  const glm::vec2 extent(imageSize(projection, size));
  return mapByTexel(projection, size, [&](int face, glm::ivec2 texel) {
    return glm::vec3(radiance(directionAt(projection, {face, (glm::vec2(texel) + 0.5f) / extent})));
  });
}

inline EnvironmentMap constantMap(Projection projection, int size, glm::vec3 radiance) {
  return mapOf(projection, size, [radiance](glm::vec3) { return radiance; });
}

inline PreparedMap prepared(EnvironmentMap map) { return *prepareMap(Environment(std::move(map))); }

/// Texel (x, y) of a panorama as a sun in the dark, and where it is.
struct Sun {
  EnvironmentMap map;
  glm::vec3 direction;
};
inline Sun sunAt(glm::ivec2 texel, int height, float radiance) {
  Sun sun{constantMap(Projection::equirect, height, glm::vec3(0.001f)), {}};
  for (int channel = 0; channel < 3; ++channel) sun.map.face(0).texel(texel.x, texel.y)[channel] = radiance;
  sun.direction = directionAt(Projection::equirect, {0, (glm::vec2(texel) + 0.5f) / glm::vec2(sun.map.extent())});
  return sun;
}

/// The settings of one projection's picture.
inline MapViewSettings settingsOf(Projection::Kind projection) {
  MapViewSettings settings;
  settings.page = MapPage::one;
  settings.projection = projection;
  return settings;
}

}  // namespace mirrorball::testing
