#include "mirrorball/environment/convert/supersampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "formula/constants.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

/// The angle over which the source's positions are compared: far above what float positions resolve, far below
/// what a projection bends over.
constexpr float kProbe_rad = 1e-3f;

/// How many texels lie between two positions; infinitely many between faces.
float texelsBetween(const EnvironmentMap& map, MapPosition a, MapPosition b) {
  if (a.face != b.face) return std::numeric_limits<float>::infinity();
  glm::vec2 difference = b.uv - a.uv;
  if (map.projection() == Projection::equirect) {
    difference.x -= std::round(difference.x);
    // Towards the poles a panorama's rows repeat themselves: along them it shows no more detail than across.
    difference.x *= std::sin(a.uv.y * formula::kPi);
  }
  return glm::length(difference * glm::vec2(map.extent()));
}

/// How many of the source's texels a step from a direction spans.
///
/// step     tangent to the sphere at `direction`, its length the angle in radians
float texelsAlong(const EnvironmentMap& map, glm::vec3 direction, glm::vec3 step) {
  const float angle = glm::length(step);
  if (angle == 0.0f) return 0.0f;
  const glm::vec3 probe = step * (kProbe_rad / angle);
  const MapPosition middle = positionOf(map.projection(), direction);
  // Across an edge or a fold the positions jump, but on one side of the middle they do not.
  const float texels =
      std::min(texelsBetween(map, middle, positionOf(map.projection(), glm::normalize(direction - probe))),
               texelsBetween(map, middle, positionOf(map.projection(), glm::normalize(direction + probe))));
  return texels * angle / kProbe_rad;
}

float spanOf(const Environment& source, glm::vec3 direction, glm::vec3 step) {
  if (const EnvironmentMap* map = source.map()) return texelsAlong(*map, direction, step);
  return glm::length(step) * source.texelDensity();
}

/// How many of the source's texels one texel at that place of the target spans, across and down.
glm::vec2 spanAt(const Environment& source, Projection to, glm::ivec2 extent, MapPosition place,
                 const glm::mat3& source_from_target) {
  const glm::vec2 half_texel = 0.5f / glm::vec2(extent);
  const auto directionBeside = [&](glm::vec2 texels) {
    return source_from_target * directionAt(to, {place.face, place.uv + texels * half_texel});
  };
  const glm::vec3 direction = source_from_target * directionAt(to, place);
  const glm::vec3 across = directionBeside({1.0f, 0.0f}) - directionBeside({-1.0f, 0.0f});
  const glm::vec3 down = directionBeside({0.0f, 1.0f}) - directionBeside({0.0f, -1.0f});
  return {spanOf(source, direction, across), spanOf(source, direction, down)};
}

int smoothPoints(float span) { return span > 1.415f ? static_cast<int>(std::ceil(span)) : 1; }

int sharpPoints(float span) {
  return std::max(std::min(static_cast<int>(std::ceil(6.0f * span)), 48), smoothPoints(span));
}

}  // namespace

PointsPerTexel pointsPerTexel(const Environment& source, Projection to, glm::ivec2 extent, int face, glm::ivec2 begin,
                              glm::ivec2 end, const glm::mat3& source_from_target) {
  const glm::vec2 low = (glm::vec2(begin) + 0.5f) / glm::vec2(extent);
  const glm::vec2 high = (glm::vec2(end) - 0.5f) / glm::vec2(extent);
  const std::array<glm::vec2, 5> places{low, high, glm::vec2(low.x, high.y), glm::vec2(high.x, low.y),
                                        (low + high) / 2.0f};
  glm::vec2 span(0.0f);
  for (const glm::vec2 place : places)
    if (covers(to, place)) span = glm::max(span, spanAt(source, to, extent, {face, place}, source_from_target));
  // At a pole or on a rim a map shows one direction many times over: there the Jacobian grows without bound.
  const float max = 4.0f * std::max(source.texelDensity() / texelDensity(to, extent.y), 1.0f);
  span = glm::min(span, max);
  return {{smoothPoints(span.x), smoothPoints(span.y)},
          {sharpPoints(span.x), sharpPoints(span.y)},
          glm::ivec2(glm::clamp(1.5f / glm::max(span, 1e-6f), 1.0f, 1024.0f))};
}

}  // namespace mirrorball
