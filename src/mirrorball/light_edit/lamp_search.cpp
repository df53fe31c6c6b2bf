#include "mirrorball/light_edit/lamp_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "formula/color.h"
#include "mirrorball/bake/prefilter/bright_lights.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/range.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/light_edit/lamp_outline.h"
#include "mirrorball/light_edit/lamp_texels.h"
#include "mirrorball/light_edit/map_texel.h"

namespace mirrorball {
namespace {

constexpr float kBodyShare = 1.0f / 16.0f;  // of its brightest texel
constexpr float kSmallReach_rad = 0.0436f;  // 2.5°
constexpr int kLeastPlateau = 4;            // texels

float brightestChannel(glm::vec3 light) { return std::max({light.x, light.y, light.z}); }

/// The bright texels of a map, by their numbers in this list, and which of them belong to no lamp yet.
class BrightTexels {
 public:
  explicit BrightTexels(const EnvironmentMap& map) : map_(map) {
    for (const Excess& excess : brightLights(map, std::numeric_limits<int>::max()).texels) {
      texels_.push_back({excess.face, excess.texel});
      indices_.push_back(indexOf(texels_.back()));
    }
    is_left_.assign(texels_.size(), true);
  }

  std::size_t count() const { return texels_.size(); }
  const MapTexel& texel(std::size_t number) const { return texels_[number]; }
  float brightness(std::size_t number) const { return brightestChannel(radianceOf(map_, texels_[number])); }
  bool isLeft(std::size_t number) const { return is_left_[number]; }

  /// Takes what is left of those that are connected with a body, are not darker than `least` and then belong to it.
  void growBody(std::vector<std::size_t>& body, float least) {
    for (std::size_t next = 0; next < body.size(); ++next)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) take(texelBeside(map_, texels_[body[next]], {x, y}), least, body);
  }

  /// Takes a texel if it is bright, left and not darker than `least`.
  void take(const MapTexel& texel, float least, std::vector<std::size_t>& taken) {
    const auto found = std::lower_bound(indices_.begin(), indices_.end(), indexOf(texel));
    if (found == indices_.end() || *found != indexOf(texel)) return;
    const auto number = static_cast<std::size_t>(found - indices_.begin());
    if (!is_left_[number] || brightness(number) < least) return;
    is_left_[number] = false;
    taken.push_back(number);
  }

 private:
  std::size_t indexOf(const MapTexel& texel) const {
    const glm::ivec2 extent = map_.extent();
    return (std::size_t(texel.face) * std::size_t(extent.y) + std::size_t(texel.place.y)) * std::size_t(extent.x) +
           std::size_t(texel.place.x);
  }

  const EnvironmentMap& map_;
  std::vector<MapTexel> texels_;
  std::vector<std::size_t> indices_;  // of the texels, growing
  std::vector<bool> is_left_;
};

/// The moments of some texels' light.
class LightMoments {
 public:
  void add(const EnvironmentMap& map, const MapTexel& texel) {
    const auto angle = double(texelSolidAngle(map.projection(), map.extent(), texel.place));
    const glm::dvec3 flux = glm::dvec3(radianceOf(map, texel)) * angle;
    const auto luminance = double(formula::luminance(glm::vec3(flux)));
    flux_ += flux;
    weight_ += luminance;
    towards_ += luminance * directionOf(map, texel);
    spread_ += luminance * angle / 12.0;  // of a square texel about its centre: 1 − cos θ in the mean
  }

  glm::vec3 irradiance() const { return glm::vec3(flux_); }

  /// What lies evenly all around has no middle.
  glm::vec3 direction() const {
    const double length = glm::length(towards_);
    return length > 0.0 ? glm::vec3(towards_ / length) : glm::vec3(0.0f, 0.0f, 1.0f);
  }

  /// Of a disc of radius r the mean of cos θ is (1 + cos r) / 2, so that 1 less that mean is sin²(r/2).
  float angularSize_rad() const {
    const double square = (weight_ - glm::length(towards_) + spread_) / weight_;
    return static_cast<float>(4.0 * std::asin(std::sqrt(std::clamp(square, 0.0, 1.0))));
  }

 private:
  glm::dvec3 flux_{0.0};
  glm::dvec3 towards_{0.0};
  double weight_ = 0.0;
  double spread_ = 0.0;
};

/// The corners of a lamp's texels.
std::vector<glm::vec3> texelCorners(const EnvironmentMap& map, const BrightTexels& bright,
                                    std::span<const std::size_t> body) {
  std::vector<glm::vec3> corners;
  corners.reserve(4 * body.size());
  for (const std::size_t number : body) {
    const MapTexel& texel = bright.texel(number);
    for (const glm::ivec2 corner : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)})
      corners.push_back(
          directionAt(map.projection(), {texel.face, glm::vec2(texel.place + corner) / glm::vec2(map.extent())}));
  }
  return corners;
}

/// Whether its brightest texels are as many as a sensor's or a format's limit leaves.
bool isClipped(const BrightTexels& bright, std::span<const std::size_t> body, float brightest_of_map) {
  const auto at_limit = std::count_if(
      body.begin(), body.end(), [&](std::size_t number) { return bright.brightness(number) == brightest_of_map; });
  return at_limit >= kLeastPlateau;
}

class LampFinder {
 public:
  explicit LampFinder(const EnvironmentMap& map) : map_(map), bright_(map) {}

  std::vector<LampTexels> find() {
    std::vector<std::size_t> order(bright_.count());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return bright_.brightness(a) > bright_.brightness(b); });
    std::vector<LampTexels> lamps;
    for (const std::size_t brightest : order)
      if (bright_.isLeft(brightest)) lamps.push_back(lampFrom(brightest, bright_.brightness(order.front())));
    return lamps;
  }

 private:
  LampTexels lampFrom(std::size_t brightest, float brightest_of_map) {
    const float least = kBodyShare * bright_.brightness(brightest);
    std::vector<std::size_t> body;
    bright_.take(bright_.texel(brightest), 0.0f, body);
    bright_.growBody(body, least);
    const MapLamp found = makeLamp(body, {});
    std::vector<std::size_t> glow;
    if (found.reach_rad() > kSmallReach_rad)
      bright_.growBody(body, 0.0f);
    else
      takeGlow(found, least, body, glow);
    LampTexels whole{makeLamp(body, glow), {}};
    whole.lamp.is_clipped = isClipped(bright_, body, brightest_of_map);
    for (const std::vector<std::size_t>* const part : {&body, &glow})
      for (const std::size_t number : *part) whole.texels.push_back(bright_.texel(number));
    return whole;
  }

  /// What else is bright around a small lamp: parts of it, and its glow.
  void takeGlow(const MapLamp& lamp, float least, std::vector<std::size_t>& body, std::vector<std::size_t>& glow) {
    forEachTexelNear(map_, lamp.direction, lamp.reach_rad() + glowReach_rad(map_),
                     [&](const MapTexel& texel, glm::dvec3) {
                       bright_.take(texel, least, body);
                       bright_.take(texel, 0.0f, glow);
                     });
  }

  MapLamp makeLamp(std::span<const std::size_t> body, std::span<const std::size_t> glow) const {
    LightMoments of_body;
    LightMoments of_glow;
    for (const std::size_t number : body) of_body.add(map_, bright_.texel(number));
    for (const std::size_t number : glow) of_glow.add(map_, bright_.texel(number));
    MapLamp lamp{.direction = of_body.direction(),
                 .irradiance = of_body.irradiance() + of_glow.irradiance(),
                 .angular_size_rad = of_body.angularSize_rad()};
    lamp.outline = outlineAround(lamp.direction, texelCorners(map_, bright_, body));
    return lamp;
  }

  const EnvironmentMap& map_;
  BrightTexels bright_;
};

}  // namespace

float glowReach_rad(const EnvironmentMap& map) { return std::max(kGlow_rad, 2.0f * texelWidth_rad(map)); }

Result<EnvironmentMap> searchedMap(Environment environment, const ProgressFunction& progress) {
  EnvironmentMap* map = environment.map();
  if (map != nullptr && hasKnownNeighbours(map->projection())) return std::move(*map);
  return searchedPanorama(environment, progress);
}

Result<EnvironmentMap> searchedPanorama(const Environment& environment, const ProgressFunction& progress) {
  return convert(environment, Projection::equirect, environment.naturalSize(Projection::equirect), {}, progress);
}

glm::vec3 wholeLight(const EnvironmentMap& map) {
  const glm::ivec2 extent = map.extent();
  std::vector<glm::dvec3> rows(std::size_t(extent.y) * std::size_t(map.faces()), glm::dvec3(0.0));
  parallelFor(rows.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const auto face = static_cast<int>(row / std::size_t(extent.y));
      const auto y = static_cast<int>(row % std::size_t(extent.y));
      std::optional<float> of_row;  // a panorama's texels are all alike in a row
      if (map.projection() == Projection::equirect) of_row = texelSolidAngle(map.projection(), extent, {0, y});
      for (int x = 0; x < extent.x; ++x)
        rows[row] += glm::dvec3(rgbAt(map.face(face), x, y)) *
                     double(of_row ? *of_row : texelSolidAngle(map.projection(), extent, {x, y}));
    }
  });
  return glm::vec3(std::accumulate(rows.begin(), rows.end(), glm::dvec3(0.0)));
}

std::vector<LampTexels> findLampTexels(const EnvironmentMap& map, glm::vec3 all, const LampSettings& settings) {
  assert(hasKnownNeighbours(map.projection()));
  std::vector<LampTexels> found = LampFinder(map).find();
  for (LampTexels& each : found) each.lamp.share = std::min(each.lamp.illuminance() / formula::luminance(all), 1.0f);
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const LampTexels& each) { return !(each.lamp.share >= settings.min_share); }),
              found.end());
  sortDownBy(found, [](const LampTexels& each) { return each.lamp.illuminance(); });
  found.resize(std::min(found.size(), static_cast<std::size_t>(settings.max)));
  return found;
}

std::vector<MapLamp> findLamps(const EnvironmentMap& map, glm::vec3 all, const LampSettings& settings) {
  std::vector<MapLamp> lamps;
  for (LampTexels& found : findLampTexels(map, all, settings)) lamps.push_back(std::move(found.lamp));
  return lamps;
}

}  // namespace mirrorball
