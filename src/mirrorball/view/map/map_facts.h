#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/view/map/map_layout.h"
#include "mirrorball/view/map/prepared_map.h"

namespace mirrorball {

/// A line of what is known of a pixel.
struct MapFact {
  std::string_view name;
  std::string value;
  std::string_view unit = {};
};

/// What lies under the pointer, step by step as a look-up goes (docs/techniques/look_up.md): the pixel, its direction,
/// the longest component and so the cube's face, what OpenGL's table projects on it, (s, t) and the cube's texel; then
/// the map's own texel, its radiance, the same as 16-bit halves, and whether that is light; at last the radiance that
/// is shown, where it is not the map's own.
///
/// pixel    from the upper left corner, its fractions too
/// returns  no rows beside the light of a map
/// cost     microseconds
std::vector<MapFact> mapFactsAt(const PreparedMap& map, const MapViewSettings& settings, const MapCanvas& canvas,
                                glm::vec2 pixel);

/// What is known of the whole map: its size, bad texels by kind, lamps with direction, solid angle, radiance and share
/// of the light, and the harmonics up to the degree that is chosen, as "band, order: red green blue".
std::vector<MapFact> mapFacts(const PreparedMap& map, const MapViewSettings& settings);

}  // namespace mirrorball
