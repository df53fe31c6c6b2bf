#include "mirrorball/light_edit/sun_split.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/gtc/constants.hpp>

#include "mirrorball/light_edit/lamp_search.h"
#include "mirrorball/light_edit/lamp_split.h"

namespace mirrorball {
namespace {

constexpr LampSettings kSuns{.max = kMostSuns, .min_share = 0.05f};
constexpr float kStrong = 0.2f;

/// How many rows a panorama must have to show a disc.
int rowsFor(float radius) {
  constexpr float kTexelsAcross = 4.0f;
  constexpr float kMostRows = 8192.0f;
  return static_cast<int>(std::min(glm::pi<float>() * kTexelsAcross / (2.0f * radius), kMostRows));
}

}  // namespace

Result<SunlessEnvironment> withoutSuns(const Environment& environment) {
  MIRRORBALL_TRY(map, searchedMap(environment));
  SplitMap split = splitMap(std::move(map), kSuns);
  if (split.taken.empty()) return SunlessEnvironment{environment, {}};
  std::vector<formula::Sun> suns;
  for (const MapLamp& lamp : takenLamps(split))
    suns.push_back({lamp.direction, 0.5f * lamp.angular_size_rad, lamp.irradiance});
  return SunlessEnvironment{Environment(std::move(split.rest)), std::move(suns)};
}

Environment withSuns(SunlessEnvironment split) {
  if (split.suns.empty()) return std::move(split.rest);
  int rows = split.rest.naturalSize(Projection::equirect);
  for (const formula::Sun& sun : split.suns) rows = std::max(rows, rowsFor(sun.radius));
  return Environment(
      [split = std::move(split)](glm::vec3 direction) {
        glm::vec3 light = split.rest.radiance(direction);
        for (const formula::Sun& sun : split.suns) light += formula::sunInLobe(sun, direction, 0.0f, 0.0f);
        return light;
      },
      rows);
}

Result<bool> hasStrongSun(const Environment& environment) {
  MIRRORBALL_TRY(map, searchedMap(environment));
  const std::vector<MapLamp> lamps = findLamps(map, wholeLight(map), kSuns);
  return std::any_of(lamps.begin(), lamps.end(), [](const MapLamp& lamp) {
    return lamp.share > kStrong && glm::degrees(lamp.angular_size_rad) <= kSuns.max_size_deg;
  });
}

}  // namespace mirrorball
