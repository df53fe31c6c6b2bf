#include "mirrorball/transfer/dense_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "formula/bsdf.h"
#include "mirrorball/rays/frame.h"
#include "mirrorball/rays/surface_point.h"

namespace mirrorball {
namespace {

// All in radii of the light model.

/// How far from the surface rays without a cage go.
constexpr float kReach = 0.05f;

/// How far before the surface rays begin, which may be where the dense one is.
constexpr float kStart = 1e-4f;

/// How far behind a surface that faces away the next is looked for.
constexpr float kStep = 1e-6f;

/// How many such surfaces are passed.
constexpr int kMostPassed = 32;

}  // namespace

Result<DenseModel> DenseModel::make(const Scene& scene, float radius) {
  MIRRORBALL_TRY(geometry, Geometry::make(scene));
  return DenseModel(scene, std::move(geometry), radius);
}

DenseModel::DenseModel(const Scene& scene, Geometry geometry, float radius)
    : scene_(&scene), geometry_(std::move(geometry)), world_from_normal_(normalMatrices(scene)), radius_(radius) {}

std::optional<DensePlace> DenseModel::placeAlong(glm::vec3 origin, glm::vec3 outwards, float cage) const {
  if (cage > 0.0f) return firstFacing(origin, outwards, cage, -1.0f, 2.0f * cage);
  const float start = kStart * radius_;
  const auto outside = firstFacing(origin, outwards, -start, 1.0f, kReach * radius_);
  const auto inside = firstFacing(origin, outwards, start, -1.0f, kReach * radius_);
  if (!outside || !inside) return outside ? outside : inside;
  return std::abs(outside->height) < std::abs(inside->height) ? outside : inside;
}

/// Along a ray that begins `start` outside, in the direction `way` · outwards.
std::optional<DensePlace> DenseModel::firstFacing(glm::vec3 origin, glm::vec3 outwards, float start, float way,
                                                  float reach) const {
  const glm::vec3 begin = origin + start * outwards;
  float nearest = 0.0f;
  for (int passed = 0; passed < kMostPassed; ++passed) {
    const std::optional<Hit> hit = geometry_.hit(begin, way * outwards, nearest);
    if (!hit || hit->distance > reach) return std::nullopt;
    if (glm::dot(hit->geometric_normal, outwards) > 0.0f) {
      const float height = start + way * hit->distance;
      const SurfacePoint point = surfacePointAt(*scene_, world_from_normal_[hit->instance], *hit, ReliefKind::none);
      return DensePlace{height, origin + height * outwards, hit->geometric_normal, point.normal};
    }
    nearest = hit->distance + std::max(kStep * radius_, kStep * hit->distance);
  }
  return std::nullopt;
}

VisibleSky DenseModel::skyAt(const DensePlace& place, SampleSequence samples, int rays) const {
  const Frame frame(place.normal);
  const glm::vec3 origin = place.position + kStart * radius_ * place.geometric_normal;
  int free = 0;
  glm::vec3 sum(0.0f);
  for (int i = 0; i < rays; ++i) {
    const glm::vec3 direction = frame.toWorld(formula::sampleDiffuse(samples.next()));
    if (glm::dot(direction, place.geometric_normal) <= 0.0f || geometry_.hit(origin, direction, 0.0f)) continue;
    ++free;
    sum += direction;
  }
  const bool has_mean = glm::dot(sum, sum) > 0.0f;
  return {float(free) / float(rays), has_mean ? glm::normalize(sum) : place.normal};
}

}  // namespace mirrorball
