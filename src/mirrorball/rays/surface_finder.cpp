#include "mirrorball/rays/surface_finder.h"

#include <algorithm>
#include <cmath>

#include "formula/bodies.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/scene/bodies/surrounding_media.h"

namespace mirrorball {
namespace {

/// The next surface after so many cut-away or transparent ones is taken as solid.
constexpr int kMaxPassed = 512;

}  // namespace

Surfaces surfacesOf(ReliefKind kind) { return movesSurface(kind) ? Surfaces::reliefs : Surfaces::triangles; }

/// Whether a ray goes on as if a triangle were not there: it is the one that it leaves, it is cut away, it lets this
/// ray through, it is the back of a surface that has only a front, or of a body where another one fills the place.
bool SurfaceFinder::passes(const Hit& hit, Ray& ray, bool meets_bodies_alone) {
  if (ray.from && !ray.from->relief && ray.from->instance == hit.instance && ray.from->triangle == hit.triangle)
    return true;
  const Material& material = materialOf(scene_, hit.instance);
  const bool is_entering = glm::dot(ray.direction, hit.geometric_normal) < 0.0f;
  // doubleSided does not count for bodies, and does for sheets of glass (KHR_materials_volume, "Properties").
  if (!is_entering && !material.double_sided && !isBody(material)) return true;
  const bool is_there = hit.distance >= ray.nearest && !isHole(hit);
  if (!isBody(material)) return !is_there || (meets_bodies_alone && ray.from);
  const int body = static_cast<int>(hit.instance);
  if (is_there && formula::hasSurface(ray.media, body, material.priority, is_entering)) return false;
  // Also at a hole a body begins or ends.
  ray.media = is_entering ? formula::entered(ray.media, body, material.priority) : formula::left(ray.media, body);
  return true;
}

/// Whether a surface is cut away there, or lets this ray through.
bool SurfaceFinder::isHole(const Hit& hit) {
  const float opacity = opacityAt(scene_, hit);
  return opacity <= 0.0f || (opacity < 1.0f && chance_() >= opacity);
}

std::optional<Hit> SurfaceFinder::first(Ray& ray, float farthest, bool meets_bodies_alone, glm::vec3& share) {
  float absorbed_to = ray.nearest;
  const auto absorbTo = [&](const formula::Media& media, float distance) {
    if (distance > absorbed_to && distance < INFINITY) share *= transmittance(media, distance - absorbed_to);
    absorbed_to = std::max(distance, absorbed_to);
  };
  float nearest = 0.0f;
  for (int passed = 0;; ++passed) {
    const auto hit = geometry_.hit(ray.origin, ray.direction, nearest, surfaces_);
    const bool is_reached = hit && hit->distance < farthest;
    const formula::Media before = ray.media;
    const bool is_passed = is_reached && passed < kMaxPassed && passes(*hit, ray, meets_bodies_alone);
    absorbTo(before, is_reached ? hit->distance : farthest);
    if (!is_reached) return std::nullopt;
    if (!is_passed) return hit;
    nearest = justBehind(hit->distance);
  }
}

/// What the body that fills a place leaves of light over a distance.
glm::vec3 SurfaceFinder::transmittance(const formula::Media& media, float distance) const {
  const int filling = formula::fillingBody(media);
  if (filling < 0) return glm::vec3(1.0f);
  const Material& material = materialOf(scene_, std::size_t(filling));
  return formula::bodyTransmittance(material.attenuation_color, material.attenuation_distance, distance);
}

}  // namespace mirrorball
