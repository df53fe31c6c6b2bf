#include "mirrorball/environment/cube_edges.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "formula/color.h"

namespace mirrorball {
namespace {

float lightAt(const EnvironmentMap& cube, int face, glm::ivec2 texel) {
  return std::max(formula::luminance(rgbAt(cube.face(face), texel.x, texel.y)), 0.0f);
}

/// The light of the texel that another face has in the direction where this one, continued, would have `texel`.
float lightBeyond(const EnvironmentMap& cube, int face, glm::ivec2 texel) {
  const auto side = static_cast<float>(cube.size());
  const glm::vec2 uv = (glm::vec2(texel) + 0.5f) / side;
  const MapPosition place = positionOf(cube.projection(), directionAt(cube.projection(), {face, uv}));
  return lightAt(cube, place.face, glm::clamp(glm::ivec2(place.uv * side), 0, cube.size() - 1));
}

float difference(float a, float b) { return a + b > 0.0f ? std::abs(a - b) / (a + b) : 0.0f; }

}  // namespace

EdgeFit edgeFit(const EnvironmentMap& cube) {
  assert(cube.faces() == 6);
  constexpr int kPlaces = 128;  // along an edge
  const int side = cube.size();
  if (side < 4) return {};
  const int step = std::max(1, side / kPlaces);
  constexpr std::array<glm::ivec2, 4> kOutwards{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  double across = 0.0;
  double beside = 0.0;
  int count = 0;
  for (int face = 0; face < 6; ++face)
    for (const glm::ivec2 outward : kOutwards)
      for (int along = 0; along < side; along += step) {
        const glm::ivec2 border(outward.x > 0   ? side - 1
                                : outward.x < 0 ? 0
                                                : along,
                                outward.y > 0   ? side - 1
                                : outward.y < 0 ? 0
                                                : along);
        const float light = lightAt(cube, face, border);
        across += double(difference(light, lightBeyond(cube, face, border + outward)));
        beside += double(difference(light, lightAt(cube, face, border - outward)));
        ++count;
      }
  return {float(across / count), float(beside / count)};
}

}  // namespace mirrorball
