#include "mirrorball/height_field/horizon_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mirrorball/height_field/horizon_sweep.h"
#include "mirrorball/image/halve.h"

namespace mirrorball {
namespace {

constexpr int kLongestSide = 512;
constexpr int kAzimuths = 8;
constexpr int kLayers = 2;

Image small(const Image& heights) {
  const auto isSmall = [](const Image& map) { return std::max(map.width(), map.height()) <= kLongestSide; };
  if (isSmall(heights)) return heights;
  Image map = halved(heights);
  while (!isSmall(map)) map = halved(map);
  return map;
}

/// The number of an azimuth, from growing u towards growing v.
int azimuthNumber(glm::vec2 away) {
  const float angle = std::atan2(-away.y, away.x) / std::numbers::pi_v<float>;
  return (static_cast<int>(std::lround(4.0f * angle)) + kAzimuths) % kAzimuths;
}

}  // namespace

Result<HorizonMap> horizonMap(const Image& heights, MapEdges edges, const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(checkHeights(heights));
  MIRRORBALL_TRY_VOID(checkRange(heights));
  const Image map = small(heights);
  const int levels = levelCount(std::max(map.width(), map.height()));
  HorizonMap horizons{ImageSet(levels, 1, kLayers)};
  for (int layer = 0; layer < kLayers; ++layer) horizons.slopes.at(0, 0, layer) = Image(map.width(), map.height(), 4);
  const auto store = [&](const HorizonSlice& slice) {
    const int azimuth = azimuthNumber(slice.away);
    horizons.slopes.at(0, 0, azimuth / 4).texel(slice.texel.x, slice.texel.y)[azimuth % 4] = slice.slope;
  };
  MIRRORBALL_TRY_VOID(sweepHorizons(map, {.edges = edges}, kAzimuths, progress, store));
  for (int level = 1; level < levels; ++level)
    for (int layer = 0; layer < kLayers; ++layer)
      horizons.slopes.at(level, 0, layer) = halved(horizons.slopes.at(level - 1, 0, layer));
  return horizons;
}

}  // namespace mirrorball
