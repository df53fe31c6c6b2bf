#include "mirrorball/light_edit/sun_split.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <glm/gtc/constants.hpp>

#include "formula/color.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/light_edit/lamp_search.h"
#include "mirrorball/light_edit/lamp_split.h"

namespace mirrorball {
namespace {

constexpr LampSettings kLamps{.max = 20, .min_share = 0.05f};  // more have no such share
constexpr float kStrong = 0.2f;

bool isSmall(const MapLamp& lamp) { return glm::degrees(lamp.angular_size_rad) <= kLamps.max_size_deg; }

/// The strongest of a map's small lamps.
///
/// all   wholeLight of it
std::vector<MapLamp> sunsOf(const EnvironmentMap& map, glm::vec3 all) {
  std::vector<MapLamp> suns = findLamps(map, all, kLamps);
  std::erase_if(suns, [](const MapLamp& lamp) { return !isSmall(lamp); });
  suns.resize(std::min(suns.size(), std::size_t(kMostSuns)));
  return suns;
}

/// Whether a lamp as bright as the brightest texel could have enough of the light, found without looking for it.
bool isBrightEnough(const EnvironmentMap& map, glm::vec3 all) {
  const float widest_rad = 2.0f * glm::radians(kLamps.max_size_deg);  // the mean size of one that fades is smaller
  const float widest_sr = glm::pi<float>() * widest_rad * widest_rad / 4.0f;
  float brightest = 0.0f;
  for (int face = 0; face < map.faces(); ++face) brightest = std::max(brightest, largestSample(map.face(face)));
  return brightest * widest_sr > kStrong * formula::luminance(all);
}

std::optional<glm::vec3> strongSunIn(const EnvironmentMap& map) {
  const glm::vec3 all = wholeLight(map);
  if (!isBrightEnough(map, all)) return std::nullopt;
  const std::vector<MapLamp> suns = sunsOf(map, all);
  if (suns.empty() || suns.front().share <= kStrong) return std::nullopt;
  return suns.front().direction;
}

/// How many rows a panorama must have to show a disc.
int rowsFor(float radius) {
  constexpr float kTexelsAcross = 4.0f;
  constexpr float kFinest = 8192.0f;
  return static_cast<int>(std::min(glm::pi<float>() * kTexelsAcross / (2.0f * radius), kFinest));
}

}  // namespace

Result<SunlessEnvironment> withoutSuns(const Environment& environment) {
  MIRRORBALL_TRY(map, searchedMap(environment));
  const std::vector<MapLamp> found = sunsOf(map, wholeLight(map));
  SplitMap split = splitLamps(std::move(map), found, glm::radians(kLamps.max_size_deg));
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

Result<std::optional<glm::vec3>> strongSun(const Environment& environment) {
  const EnvironmentMap* map = environment.map();
  if (map != nullptr && (map->projection() == Projection::equirect || map->projection() == Projection::cube))
    return strongSunIn(*map);
  constexpr int kRows = 256;
  MIRRORBALL_TRY(coarse, convert(environment, Projection::equirect,
                                 std::min(environment.naturalSize(Projection::equirect), kRows)));
  return strongSunIn(coarse);
}

Result<bool> hasStrongSun(const Environment& environment) {
  MIRRORBALL_TRY(sun, strongSun(environment));
  return sun.has_value();
}

}  // namespace mirrorball
