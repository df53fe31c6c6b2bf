#include "mirrorball/environment/convert/supersampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "formula/constants.h"
#include "mirrorball/environment/convert/point_batch.h"
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

/// Five points a place: itself, and to both sides of it across and down.
constexpr std::array<glm::vec2, 5> kBeside{glm::vec2(0.0f), {-1.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, -1.0f}, {0.0f, 1.0f}};

using Places = std::array<glm::vec2, 5>;
constexpr std::size_t kPoints = std::tuple_size_v<Places> * kBeside.size();

glm::vec3 directionOf(const PointBatch& batch, std::size_t point) {
  return {batch.x[point], batch.y[point], batch.z[point]};
}

void setDirection(PointBatch& batch, std::size_t point, glm::vec3 direction) {
  batch.x[point] = direction.x;
  batch.y[point] = direction.y;
  batch.z[point] = direction.z;
}

MapPosition positionIn(const PointBatch& batch, std::size_t point) {
  return {batch.face[point], {batch.u[point], batch.v[point]}};
}

/// How far a texel at each place reaches, across and down.
struct Steps {
  Places angles_rad;
  PointBatch probes;  ///< directions: each place's own, and at kProbe_rad to both sides across and down
};

Steps stepsAt(Projection to, int face, const Places& places, glm::ivec2 extent, const glm::mat3& source_from_target) {
  PointBatch edges;
  edges.count = kPoints;
  for (std::size_t point = 0; point < kPoints; ++point) {
    const glm::vec2 uv = places[point / 5] + kBeside[point % 5] * 0.5f / glm::vec2(extent);
    edges.face[point] = face;
    edges.u[point] = uv.x;
    edges.v[point] = uv.y;
  }
  directionsAt(to, edges);
  turn(source_from_target, edges);

  Steps steps;
  steps.probes.count = kPoints;
  for (std::size_t place = 0; place < places.size(); ++place) {
    const std::size_t middle = 5 * place;
    const glm::vec3 direction = directionOf(edges, middle);
    setDirection(steps.probes, middle, direction);
    for (const int axis : {0, 1}) {
      const std::size_t before = middle + 1 + 2 * static_cast<std::size_t>(axis);
      const glm::vec3 step = directionOf(edges, before + 1) - directionOf(edges, before);
      const float angle = glm::length(step);
      const glm::vec3 probe = angle > 0.0f ? step * (kProbe_rad / angle) : step;
      steps.angles_rad[place][axis] = angle;
      setDirection(steps.probes, before, glm::normalize(direction - probe));
      setDirection(steps.probes, before + 1, glm::normalize(direction + probe));
    }
  }
  return steps;
}

/// How many of the source's texels one texel of the target spans at most at some places, across and down.
glm::vec2 maxSpan(const Environment& source, Steps& steps, const std::array<bool, 5>& counts) {
  glm::vec2 span(0.0f);
  const EnvironmentMap* map = source.map();
  if (map) positionsOf(map->projection(), steps.probes);
  for (std::size_t place = 0; place < counts.size(); ++place) {
    if (!counts[place]) continue;
    const std::size_t middle = 5 * place;
    for (const int axis : {0, 1}) {
      const float angle = steps.angles_rad[place][axis];
      const auto texelsTo = [&](std::size_t point) {
        return texelsBetween(*map, positionIn(steps.probes, middle), positionIn(steps.probes, point));
      };
      const std::size_t before = middle + 1 + 2 * static_cast<std::size_t>(axis);
      // Across an edge or a fold the positions jump, but on one side of the middle they do not.
      const float here =
          map ? std::min(texelsTo(before), texelsTo(before + 1)) * angle / kProbe_rad : angle * source.texelDensity();
      span[axis] = std::max(span[axis], angle > 0.0f ? here : 0.0f);
    }
  }
  return span;
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
  const Places places{low, high, glm::vec2(low.x, high.y), glm::vec2(high.x, low.y), (low + high) / 2.0f};
  std::array<bool, 5> covered;
  std::transform(places.begin(), places.end(), covered.begin(), [&](glm::vec2 place) { return covers(to, place); });
  Steps steps = stepsAt(to, face, places, extent, source_from_target);
  glm::vec2 span = maxSpan(source, steps, covered);
  // At a pole or on a rim a map shows one direction many times over: there the Jacobian grows without bound.
  const float max = 4.0f * std::max(source.texelDensity() / texelDensity(to, extent.y), 1.0f);
  span = glm::min(span, max);
  return {{smoothPoints(span.x), smoothPoints(span.y)},
          {sharpPoints(span.x), sharpPoints(span.y)},
          glm::ivec2(glm::clamp(1.5f / glm::max(span, 1e-6f), 1.0f, 1024.0f))};
}

}  // namespace mirrorball
