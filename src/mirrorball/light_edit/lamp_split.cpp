#include "mirrorball/light_edit/lamp_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/light_edit/lamp_search.h"
#include "mirrorball/light_edit/map_texel.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRings = 8;     // in which the glow is measured
constexpr double kAsSky = 1.25;       // times the light of the last ring
constexpr std::size_t kArcs = 256;    // into which a cap's edge is cut
constexpr double kStandsOut = 4.0;    // times the median of the edge: another lamp
constexpr float kEdge_texels = 1.5f;  // how wide the edge is

/// A texel near a lamp.
struct NearTexel {
  MapTexel texel;
  glm::dvec3 direction;
};

/// Light along the edge of a cap.
struct EdgeLight {
  glm::dvec3 direction;
  glm::dvec3 radiance;
};

std::vector<NearTexel> texelsNear(const EnvironmentMap& map, glm::vec3 middle, float angle_rad) {
  std::vector<NearTexel> texels;
  forEachTexelNear(map, middle, angle_rad, [&](const MapTexel& texel, glm::dvec3 direction) {
    texels.push_back({texel, direction});
  });
  return texels;
}

/// How far around a lamp its glow may be taken: not into what is another's.
float roomAround(const EnvironmentMap& map, const MapLamp& lamp, const std::vector<MapLamp>& all) {
  float room = glowReach_rad(map);
  for (const MapLamp& other : all) {
    if (&other == &lamp) continue;
    const auto apart = static_cast<float>(angleBetween(lamp.direction, other.direction));
    room = std::min(room, (apart - lamp.reach_rad() - other.reach_rad()) / 2.0f);
  }
  // An interpolated edge is one texel wide.
  return std::max(room, kEdge_texels * texelWidth_rad(map));
}

/// The radius of the cap that is cut out around a lamp: to the first ring that is nearly as dark as the last one.
float capAround(const EnvironmentMap& map, const MapLamp& lamp, float room) {
  const float reach = lamp.reach_rad();
  std::array<double, kRings> light{};
  std::array<double, kRings> angles{};
  for (const NearTexel& near : texelsNear(map, lamp.direction, reach + room)) {
    const double beyond = (angleBetween(lamp.direction, near.direction) - double(reach)) / double(room);
    if (beyond < 0.0) continue;
    const std::size_t ring = std::min(static_cast<std::size_t>(beyond * kRings), kRings - 1);
    const auto angle = double(texelSolidAngle(map.projection(), map.extent(), near.texel.place));
    light[ring] += angle * double(formula::luminance(radianceOf(map, near.texel)));
    angles[ring] += angle;
  }
  const double least = double(kEdge_texels * texelWidth_rad(map));
  for (std::size_t ring = 0; ring < kRings; ++ring) {
    const double end = double(room) * double(ring + 1) / double(kRings);
    const bool is_as_sky = light[ring] * angles.back() <= kAsSky * light.back() * angles[ring];
    if (end >= least && angles[ring] > 0.0 && is_as_sky) return reach + static_cast<float>(end);
  }
  return reach + room;
}

/// Leaves out what stands out along an edge: other lamps.
void removeLampsOf(std::vector<EdgeLight>& edge) {
  if (edge.empty()) return;
  std::vector<double> luminances;
  for (const EdgeLight& light : edge) luminances.push_back(double(formula::luminance(glm::vec3(light.radiance))));
  std::vector<double> sorted = luminances;
  const auto median = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), median, sorted.end());
  std::vector<EdgeLight> kept;
  for (std::size_t i = 0; i < edge.size(); ++i)
    if (luminances[i] <= kStandsOut * *median) kept.push_back(edge[i]);
  edge = std::move(kept);
}

/// The mean light of each arc of a cap's edge.
std::vector<EdgeLight> edgeOf(const EnvironmentMap& map, glm::vec3 middle, float cap_rad) {
  const float width = kEdge_texels * texelWidth_rad(map);
  const glm::dmat3 frame(centredOn(middle));
  std::array<EdgeLight, kArcs> arcs{};
  std::array<double, kArcs> angles{};
  for (const NearTexel& near : texelsNear(map, middle, cap_rad + width)) {
    if (angleBetween(middle, near.direction) < double(cap_rad)) continue;
    const glm::dvec3 d = glm::transpose(frame) * near.direction;
    const double turn = std::atan2(d.y, d.x) / (2.0 * std::numbers::pi) + 0.5;
    const std::size_t arc = std::min(static_cast<std::size_t>(turn * kArcs), kArcs - 1);
    const auto angle = double(texelSolidAngle(map.projection(), map.extent(), near.texel.place));
    arcs[arc].radiance += angle * glm::dvec3(radianceOf(map, near.texel));
    arcs[arc].direction += angle * near.direction;
    angles[arc] += angle;
  }
  std::vector<EdgeLight> edge;
  for (std::size_t arc = 0; arc < kArcs; ++arc)
    if (angles[arc] > 0.0) edge.push_back({glm::normalize(arcs[arc].direction), arcs[arc].radiance / angles[arc]});
  removeLampsOf(edge);
  return edge;
}

/// Poisson's formula.
glm::vec3 lightWithin(const std::vector<EdgeLight>& edge, glm::dvec3 direction) {
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (const EdgeLight& light : edge) {
    const glm::dvec3 away = light.direction - direction;
    const double weight = 1.0 / std::max(glm::dot(away, away), std::numeric_limits<double>::min());
    sum += weight * light.radiance;
    weights += weight;
  }
  return weights > 0.0 ? glm::vec3(sum / weights) : glm::vec3(0.0f);
}

/// Gives a lamp the light that was taken.
void describe(TakenLamp& taken) {
  glm::dvec3 irradiance(0.0);
  glm::dvec3 towards(0.0);
  for (const PointOfLight& point : taken.light) {
    irradiance += glm::dvec3(point.flux);
    towards += double(formula::luminance(point.flux)) * glm::dvec3(point.direction);
  }
  MapLamp& lamp = taken.lamp;
  const float before = lamp.illuminance();
  lamp.irradiance = glm::vec3(irradiance);
  if (glm::length(towards) > 0.0) lamp.direction = glm::vec3(glm::normalize(towards));
  if (before > 0.0f) lamp.share *= lamp.illuminance() / before;
}

/// Takes one lamp out of a map.
TakenLamp takeOut(EnvironmentMap& map, const MapLamp& lamp, float room) {
  const float cap = capAround(map, lamp, room);
  const std::vector<EdgeLight> edge = edgeOf(map, lamp.direction, cap);
  const std::vector<NearTexel> inside = texelsNear(map, lamp.direction, cap);
  TakenLamp taken{lamp, std::vector<PointOfLight>(inside.size())};
  parallelFor(inside.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& [texel, direction] = inside[i];
      const glm::vec3 before = radianceOf(map, texel);
      const glm::vec3 after = glm::min(before, lightWithin(edge, direction));
      Image& image = map.face(texel.face);
      for (int c = 0; c < std::min(image.channels(), 3); ++c) image.texel(texel.place.x, texel.place.y)[c] = after[c];
      const float angle = texelSolidAngle(map.projection(), map.extent(), texel.place);
      taken.light[i] = {glm::vec3(direction), (before - after) * angle};
    }
  });
  describe(taken);
  return taken;
}

}  // namespace

SplitMap splitLamps(EnvironmentMap map, const std::vector<MapLamp>& lamps, float max_size_rad) {
  SplitMap split;
  for (const MapLamp& lamp : lamps) {
    if (lamp.angular_size_rad > max_size_rad)
      split.kept.push_back(lamp);
    else
      split.taken.push_back(takeOut(map, lamp, roomAround(map, lamp, lamps)));
  }
  split.rest = std::move(map);
  return split;
}

SplitMap splitMap(EnvironmentMap map, const LampSettings& settings) {
  const std::vector<MapLamp> lamps = findLamps(map, wholeLight(map), settings);
  return splitLamps(std::move(map), lamps, glm::radians(settings.max_size_deg));
}

std::vector<MapLamp> takenLamps(const SplitMap& split) {
  std::vector<MapLamp> lamps;
  for (const TakenLamp& taken : split.taken) lamps.push_back(taken.lamp);
  return lamps;
}

}  // namespace mirrorball
