#include "mirrorball/light_edit/lamp_scale.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <queue>
#include <string>
#include <utility>

#include "formula/color.h"
#include "mirrorball/base/memory.h"
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

/// The map that is changed, and the one in which its lamps are searched.
struct MapsToScale {
  EnvironmentMap map;
  std::optional<EnvironmentMap> other = {};  ///< where lamps cannot be searched in the map itself

  EnvironmentMap& searched() { return other ? *other : map; }
};

std::uint64_t bytesForMap(glm::ivec2 extent, int faces, int channels) {
  return std::uint64_t(faces) * std::uint64_t(channels) * std::uint64_t(extent.x) * std::uint64_t(extent.y) *
         sizeof(float);
}

std::uint64_t bytesIn(const EnvironmentMap& map) {
  return bytesForMap(map.extent(), map.faces(), map.face(0).channels());
}

bool hasNegativeLight(const EnvironmentMap& map) {
  const glm::ivec2 extent = map.extent();
  for (int face = 0; face < map.faces(); ++face)
    for (int y = 0; y < extent.y; ++y)
      for (int x = 0; x < extent.x; ++x)
        if (glm::any(glm::lessThan(rgbAt(map.face(face), x, y), glm::vec3(0.0f)))) return true;
  return false;
}

/// Takes an environment's images. Lamps are searched in these, unless their projection or light below 0 forbids it.
///
/// errors   as searchedMap's and checkLight's; too_large
Result<MapsToScale> mapsToScale(Environment environment, const Observer& observer) {
  MapsToScale maps;
  const ProgressFunction progress = observer.progressOf("convert");
  EnvironmentMap* own = environment.map();
  if (own != nullptr && !hasKnownNeighbours(own->projection())) {
    const glm::ivec2 extent = imageSize(Projection::equirect, environment.naturalSize(Projection::equirect));
    MIRRORBALL_TRY_VOID(withName("the map and the panorama in which its lamps are searched",
                                 checkMemory(environment.bytes() + bytesForMap(extent, 1, 3))));
    MIRRORBALL_TRY(panorama, searchedPanorama(environment, progress));
    maps = {std::move(*own), std::move(panorama)};
  } else {
    MIRRORBALL_TRY(map, searchedMap(std::move(environment), progress));
    maps.map = std::move(map);
    if (hasNegativeLight(maps.map)) {
      MIRRORBALL_TRY_VOID(
          withName("the map, and a copy without its light below 0", checkMemory(2 * bytesIn(maps.map))));
      maps.other = maps.map;
    }
  }
  MIRRORBALL_TRY_VOID(checkLight(maps.searched(), observer));
  return maps;
}

/// Light of the surroundings: sums over some texels at the border of a glow, weighed by their solid angle.
struct BorderLight {
  glm::dvec3 direction{0.0};
  glm::dvec3 radiance{0.0};
  double weight = 0.0;
};

/// The texels of lamps and of their glow.
class LampArea {
 public:
  /// counter  asked whether to go on; is incomplete where it has stopped
  LampArea(const EnvironmentMap& map, const std::vector<LampTexels>& lamps, ProgressCounter& counter)
      : map_(map), reach_rad_(std::max(kReach_rad, kReach_texels * texelWidth_rad(map))), weights_(emptyWeights(map)) {
    for (const LampTexels& lamp : lamps)
      for (const MapTexel& texel : lamp.texels) at(texel) = 1.0f;
    for (const LampTexels& lamp : lamps)
      for (const MapTexel& texel : lamp.texels) reachFrom(texel, directionOf(map, texel));
    spread(counter);
  }

  /// By how much each texel takes part in the change: 1 in a lamp and near it, falling smoothly to 0 around it.
  const EnvironmentMap& weights() const { return weights_; }

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
  void spread(ProgressCounter& counter) {
    constexpr float kLeast = 1e-6f;  // what has a weight is not visited again
    constexpr std::size_t kBetweenPolls = 4096;
    for (std::size_t visited = 0; !reached_.empty(); ++visited) {
      if (visited % kBetweenPolls == 0) counter.advance(0);
      if (counter.stopped()) return;
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

/// What is left of a texel's light without its lamp: that of the surroundings, where it is not darker.
glm::vec3 behindLamp(glm::vec3 light, const LampArea& area, glm::dvec3 direction) {
  return glm::min(light, area.surroundings(direction));
}

/// By how much more than K − 1 the excess over the surroundings must grow for a lamp to have K times its light.
float gainFor(const LampTexels& lamp, const EnvironmentMap& map, const LampArea& area) {
  std::vector<glm::dvec2> terms(lamp.texels.size());  // of its light and of its excess, summed in their order
  parallelFor(terms.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const MapTexel& texel = lamp.texels[i];
      const glm::vec3 light = radianceOf(map, texel);
      const auto angle = double(texelSolidAngle(map.projection(), map.extent(), texel.place));
      const auto whole = double(formula::luminance(light));
      const auto behind = double(formula::luminance(behindLamp(light, area, directionOf(map, texel))));
      terms[i] = angle * glm::dvec2(whole, whole - behind);
    }
  });
  glm::dvec2 sum(0.0);
  for (const glm::dvec2 term : terms) sum += term;
  const auto [light, excess] = std::pair(sum.x, sum.y);
  return static_cast<float>(excess * kGreatestGain > light ? light / excess : kGreatestGain);
}

/// What a change of a map goes by.
struct LampChange {
  float growth;  ///< of the excess over the surroundings: K − 1, above 0 times the gain
  const LampArea& area;
  bool is_same_map;  ///< the texels of the area are those of the map that is changed

  float weightAt(const EnvironmentMap& map, const MapTexel& texel) const {
    const EnvironmentMap& weights = area.weights();
    return is_same_map ? radianceOf(weights, texel).x : weights.radiance(glm::vec3(directionOf(map, texel))).x;
  }

  glm::vec3 changed(glm::vec3 light, float weight, glm::dvec3 direction) const {
    const glm::vec3 sky = behindLamp(light, area, direction);
    // A sum of fractions, so that surroundings are not what is left of a difference of large numbers.
    if (growth < 0.0f) return (1.0f + weight * growth) * light - weight * growth * sky;
    return light + weight * growth * (light - sky);
  }
};

/// Changes a map's texels.
///
/// returns  whether all are finite
bool apply(const LampChange& change, EnvironmentMap& map, ProgressCounter& counter) {
  const glm::ivec2 extent = map.extent();
  std::atomic<bool> is_finite = true;
  parallelFor(std::size_t(extent.y) * std::size_t(map.faces()), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end && !counter.stopped(); ++row, counter.advance())
      for (int x = 0; x < extent.x; ++x) {
        const MapTexel texel{static_cast<int>(row / std::size_t(extent.y)),
                             {x, static_cast<int>(row % std::size_t(extent.y))}};
        const glm::vec2 uv = (glm::vec2(texel.place) + 0.5f) / glm::vec2(extent);
        if (!covers(map.projection(), uv)) continue;
        const float weight = change.weightAt(map, texel);
        if (weight <= 0.0f) continue;
        const glm::vec3 light = change.changed(glm::max(radianceOf(map, texel), 0.0f), weight, directionOf(map, texel));
        Image& image = map.face(texel.face);
        for (int c = 0; c < std::min(image.channels(), 3); ++c) {
          image.texel(x, texel.place.y)[c] = light[c];
          if (!std::isfinite(light[c])) is_finite = false;
        }
      }
  });
  return is_finite;
}

/// Multiplies the light of lamps that were found in a map.
///
/// errors   out_of_range; too_large; interrupted
Result<void> scaleFound(const std::vector<LampTexels>& found, float factor, MapsToScale& maps,
                        const Observer& observer) {
  EnvironmentMap& map = maps.map;
  const EnvironmentMap& searched = maps.searched();
  const std::uint64_t held = bytesIn(map) + (maps.other ? bytesIn(*maps.other) : 0);
  MIRRORBALL_TRY_VOID(withName("the map, and weights of its texels",
                               checkMemory(held + bytesForMap(searched.extent(), searched.faces(), 1))));
  const ProgressFunction progress = observer.progressOf("scale");
  ProgressCounter counter(progress, std::size_t(map.extent().y) * std::size_t(map.faces()));
  const LampArea area(searched, found, counter);
  MIRRORBALL_TRY_VOID(counter.result());
  float growth = factor - 1.0f;
  // The strongest lamp's gain is that of all, so that lamps which touch change alike.
  if (growth > 0.0f) growth *= gainFor(found.front(), searched, area);
  const bool is_same_map = map.projection() == searched.projection() && map.extent() == searched.extent();
  const bool is_finite = apply({growth, area, is_same_map}, map, counter);
  MIRRORBALL_TRY_VOID(counter.result());
  if (is_finite) return {};
  return fail(ErrorCode::out_of_range, "its lamps become too bright for a float; use a smaller factor");
}

}  // namespace

Result<ScaledMap> scaleLamps(Environment environment, float factor, const LampSettings& settings,
                             const Observer& observer) {
  MIRRORBALL_TRY(maps, mapsToScale(std::move(environment), observer));
  const std::vector<LampTexels> found = lampsUpTo(settings.max_size_deg, maps.searched(), settings);
  if (!found.empty() && factor != 1.0f) MIRRORBALL_TRY_VOID(scaleFound(found, factor, maps, observer));
  ScaledMap scaled{std::move(maps.map), {}};
  for (const LampTexels& lamp : found) scaled.lamps.push_back(lamp.lamp);
  return scaled;
}

}  // namespace mirrorball
