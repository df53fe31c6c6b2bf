#include "mirrorball/light_edit/lamp_scale.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <map>
#include <queue>
#include <utility>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/light_edit/lamp_search.h"
#include "mirrorball/light_edit/lamp_texels.h"

namespace mirrorball {
namespace {

constexpr float kReach_rad = 0.0524f;  // 3°: how far around a lamp's texels its glow is changed
constexpr float kReach_texels = 4.0f;  // and at least
constexpr float kWhole = 0.5f;         // of the reach: the glow up to there is changed as the lamp is
constexpr float kBorder = 0.85f;       // of the reach: what is beyond it is the surroundings
constexpr double kGreatestGain = 4.0;  // where lamps hardly outshine their surroundings

/// Light of the surroundings: sums over some texels at the border of a glow, weighed by their solid angle.
struct BorderLight {
  glm::dvec3 direction{0.0};
  glm::dvec3 radiance{0.0};
  double weight = 0.0;
};

/// The texels of lamps and of their glow.
class LampArea {
 public:
  LampArea(const EnvironmentMap& map, const std::vector<LampTexels>& lamps)
      : map_(map), reach_rad_(std::max(kReach_rad, kReach_texels * texelWidth_rad(map))), weights_(emptyWeights(map)) {
    for (const LampTexels& lamp : lamps)
      for (const MapTexel& texel : lamp.texels) at(texel) = 1.0f;
    for (const LampTexels& lamp : lamps)
      for (const MapTexel& texel : lamp.texels) reachFrom(texel, directionOf(map, texel));
    spread();
  }

  /// By how much each texel takes part in the change: 1 in a lamp and near it, falling smoothly to 0 around it.
  EnvironmentMap& weights() { return weights_; }

  /// The light of the surroundings in a direction: the mean of that along the border, weighed by 1 / distance², as in
  /// splitLamps (where the border is round, it is harmonic).
  glm::vec3 surroundings(glm::dvec3 direction) const {
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (const auto& [cell, light] : border_) {
      const glm::dvec3 away = light.direction / light.weight - direction;
      const double weight = light.weight / std::max(glm::dot(away, away), 1e-12);
      sum += weight * light.radiance / light.weight;
      weights += weight;
    }
    return weights > 0.0 ? glm::vec3(sum / weights) : glm::vec3(0.0f);
  }

 private:
  /// A texel that lies near one of a lamp.
  struct Reached {
    double angle_rad;      // between the two
    glm::dvec3 direction;  // of the lamp's
    MapTexel texel;

    bool operator<(const Reached& other) const { return angle_rad > other.angle_rad; }  // the nearest comes first
  };

  static EnvironmentMap emptyWeights(const EnvironmentMap& map) {
    ImageSet images(1, map.faces());
    for (int face = 0; face < map.faces(); ++face) images.at(0, face) = Image(map.extent().x, map.extent().y, 1);
    return {map.projection(), std::move(images)};
  }

  float& at(const MapTexel& texel) { return *weights_.face(texel.face).texel(texel.place.x, texel.place.y); }

  /// Notes the neighbours of a texel that have no weight yet.
  void reachFrom(const MapTexel& texel, glm::dvec3 direction) {
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const MapTexel beside = texelBeside(map_, texel, {x, y});
        if (at(beside) > 0.0f) continue;
        const double angle = angleBetween(directionOf(map_, beside), direction);
        if (angle < double(reach_rad_)) reached_.push({angle, direction, beside});
      }
  }

  /// Dijkstra's algorithm from all lamps at once.
  void spread() {
    constexpr float kLeast = 1e-6f;  // what has a weight is not visited again
    while (!reached_.empty()) {
      const Reached next = reached_.top();
      reached_.pop();
      if (at(next.texel) > 0.0f) continue;
      const auto angle = static_cast<float>(next.angle_rad);
      at(next.texel) = std::max(1.0f - glm::smoothstep(kWhole * reach_rad_, reach_rad_, angle), kLeast);
      if (angle > kBorder * reach_rad_) addToBorder(next.texel);
      reachFrom(next.texel, next.direction);
    }
  }

  /// Sums the border's light in cells half as wide as the reach.
  void addToBorder(const MapTexel& texel) {
    const glm::dvec3 direction = directionOf(map_, texel);
    const glm::ivec3 cell(glm::floor(direction * (2.0 / double(reach_rad_))));
    const auto angle = double(texelSolidAngle(map_.projection(), map_.extent(), texel.place));
    BorderLight& light = border_[{cell.x, cell.y, cell.z}];
    light.direction += angle * direction;
    light.radiance += angle * glm::dvec3(radianceOf(map_, texel));
    light.weight += angle;
  }

  const EnvironmentMap& map_;
  float reach_rad_;
  EnvironmentMap weights_;
  std::priority_queue<Reached> reached_;
  std::map<std::array<int, 3>, BorderLight> border_;
};

std::vector<LampTexels> lampsUpTo(float size_deg, const EnvironmentMap& searched, const LampSettings& settings) {
  std::vector<LampTexels> lamps = findLampTexels(searched, wholeLight(searched), settings);
  lamps.erase(
      std::remove_if(lamps.begin(), lamps.end(),
                     [&](const LampTexels& found) { return found.lamp.angular_size_rad > glm::radians(size_deg); }),
      lamps.end());
  return lamps;
}

/// A map with the surroundings of its lamps in their place, where those are not darker.
EnvironmentMap withoutLamps(EnvironmentMap map, LampArea& area) {
  const glm::ivec2 extent = map.extent();
  parallelFor(std::size_t(extent.y) * std::size_t(map.faces()), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      for (int x = 0; x < extent.x; ++x) {
        const auto y = static_cast<int>(row % std::size_t(extent.y));
        const MapTexel texel{static_cast<int>(row / std::size_t(extent.y)), {x, y}};
        if (radianceOf(area.weights(), texel).x <= 0.0f) continue;
        const glm::vec3 behind = glm::min(radianceOf(map, texel), area.surroundings(directionOf(map, texel)));
        Image& image = map.face(texel.face);
        for (int c = 0; c < std::min(image.channels(), 3); ++c) image.texel(x, y)[c] = behind[c];
      }
  });
  return map;
}

/// By how much more than K − 1 the excess over the surroundings must grow for a lamp to have K times its light.
float gainFor(const LampTexels& lamp, const EnvironmentMap& map, const EnvironmentMap& behind) {
  double light = 0.0, excess = 0.0;
  for (const MapTexel& texel : lamp.texels) {
    const auto angle = double(texelSolidAngle(map.projection(), map.extent(), texel.place));
    const auto whole = double(formula::luminance(radianceOf(map, texel)));
    light += angle * whole;
    excess += angle * (whole - double(formula::luminance(radianceOf(behind, texel))));
  }
  return static_cast<float>(excess * kGreatestGain > light ? light / excess : kGreatestGain);
}

/// What a change of a map goes by, as maps of the one that was searched.
struct LampChange {
  float growth;  ///< of the excess over the surroundings: K − 1, above 0 times the gain
  EnvironmentMap weights;
  EnvironmentMap behind;
  bool is_same_map;  ///< its texels are those of the map that is changed

  float weightAt(const MapTexel& texel, glm::vec3 direction) const {
    return is_same_map ? radianceOf(weights, texel).x : weights.radiance(direction).x;
  }

  glm::vec3 changed(glm::vec3 light, float weight, const MapTexel& texel, glm::vec3 direction) const {
    const glm::vec3 sky = glm::min(light, is_same_map ? radianceOf(behind, texel) : behind.radiance(direction));
    // A sum of fractions, so that surroundings are not what is left of a difference of large numbers.
    if (growth < 0.0f) return (1.0f + weight * growth) * light - weight * growth * sky;
    return light + weight * growth * (light - sky);
  }
};

/// Changes a map's texels.
///
/// returns  whether all are finite
bool apply(const LampChange& change, EnvironmentMap& map) {
  const glm::ivec2 extent = map.extent();
  std::atomic<bool> is_finite = true;
  parallelFor(std::size_t(extent.y) * std::size_t(map.faces()), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      for (int x = 0; x < extent.x; ++x) {
        const MapTexel texel{static_cast<int>(row / std::size_t(extent.y)),
                             {x, static_cast<int>(row % std::size_t(extent.y))}};
        const glm::vec2 uv = (glm::vec2(texel.place) + 0.5f) / glm::vec2(extent);
        if (!covers(map.projection(), uv)) continue;
        const glm::vec3 direction =
            change.is_same_map ? glm::vec3(0.0f) : directionAt(map.projection(), {texel.face, uv});
        const float weight = change.weightAt(texel, direction);
        if (weight <= 0.0f) continue;
        const glm::vec3 light = change.changed(glm::max(radianceOf(map, texel), 0.0f), weight, texel, direction);
        Image& image = map.face(texel.face);
        for (int c = 0; c < std::min(image.channels(), 3); ++c) {
          image.texel(x, texel.place.y)[c] = light[c];
          if (!std::isfinite(light[c])) is_finite = false;
        }
      }
  });
  return is_finite;
}

}  // namespace

Result<ScaledMap> scaleLamps(EnvironmentMap map, const EnvironmentMap& searched, float factor,
                             const LampSettings& settings) {
  const std::vector<LampTexels> found = lampsUpTo(settings.max_size_deg, searched, settings);
  ScaledMap scaled{std::move(map), {}};
  for (const LampTexels& lamp : found) scaled.lamps.push_back(lamp.lamp);
  if (found.empty() || factor == 1.0f) return scaled;
  LampArea area(searched, found);
  EnvironmentMap behind = withoutLamps(searched, area);
  float growth = factor - 1.0f;
  // The strongest lamp's gain is that of all, so that lamps which touch change alike.
  if (growth > 0.0f) growth *= gainFor(found.front(), searched, behind);
  const LampChange change{
      .growth = growth,
      .weights = std::move(area.weights()),
      .behind = std::move(behind),
      .is_same_map = scaled.map.projection() == searched.projection() && scaled.map.extent() == searched.extent()};
  if (!apply(change, scaled.map))
    return fail(ErrorCode::out_of_range, "its lamps become too bright for a float; use a smaller factor");
  return scaled;
}

}  // namespace mirrorball
