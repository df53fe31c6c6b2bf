#include "mirrorball/trace/surroundings.h"

#include <algorithm>
#include <utility>

#include "formula/constants.h"
#include "formula/prefilter.h"

namespace mirrorball {
namespace {

constexpr glm::vec3 kUp(0.0f, 1.0f, 0.0f);

}  // namespace

Surroundings::Surroundings(const Environment& environment, const LightSampler& lights, Proxy proxy,
                           const TraceSettings& settings)
    : environment_(environment),
      lights_(lights),
      proxy_(std::move(proxy)),
      environment_from_world_(settings.environment_from_world),
      intensity_(settings.environment_intensity) {
  if (proxy_.kind != ProxyKind::ground) return;
  constexpr int kSamples = 4096;
  for (int i = 0; i < kSamples; ++i) {
    const LightSample light = sampleOnGround(formula::sampleOffset(i, kSamples));
    if (light.pdf > 0.0f)
      ground_irradiance_ +=
          radianceOnGround(light.direction) * (light.direction.y / (formula::kPi * light.pdf * kSamples));
  }
}

glm::vec3 Surroundings::radianceOnGround(glm::vec3 direction) const {
  return intensity_ * environment_.radiance(glm::normalize(environment_from_world_ * direction));
}

glm::vec3 Surroundings::radiance(glm::vec3 origin, glm::vec3 direction) const {
  if (proxy_.kind == ProxyKind::none) return radianceOnGround(direction);
  return radianceOnGround(sightFrom(proxy_, origin, direction).direction);
}

/// Whether what a ray sees is what is seen in the same direction from the capture, and not hidden from there.
bool Surroundings::isSeenFromCapture(const formula::ProxySight& sight) const {
  if (proxy_.kind != ProxyKind::mesh) return true;
  const formula::ProxyHit first = hitOf(proxy_, proxy_.captured_at, sight.direction);
  constexpr float kSame = 1e-3f;
  return glm::distance(first.place, sight.place) <= kSame * glm::distance(proxy_.captured_at, sight.place);
}

LightSample Surroundings::sample(glm::vec3 origin, glm::vec2 u) const {
  LightSample light = lights_.sample(u);
  light.direction = glm::transpose(environment_from_world_) * light.direction;
  if (proxy_.kind == ProxyKind::none) return light;
  const formula::ProxyHit there = hitOf(proxy_, proxy_.captured_at, light.direction);
  const bool is_far = there.normal == glm::vec3(0.0f);
  const glm::vec3 direction = is_far ? light.direction : there.place - proxy_.within(origin);
  if (direction == glm::vec3(0.0f)) return {};
  light.direction = glm::normalize(direction);
  const formula::ProxySight sight = sightFrom(proxy_, origin, light.direction);
  const bool is_seen = is_far ? sight.direction == light.direction
                              : glm::distance(sight.place, there.place) <= 1e-3f * glm::length(direction);
  light.pdf = is_seen ? light.pdf * sight.enlargement : 0.0f;
  return light;
}

float Surroundings::pdf(glm::vec3 origin, glm::vec3 direction) const {
  if (proxy_.kind == ProxyKind::none) return lights_.pdf(glm::normalize(environment_from_world_ * direction));
  const formula::ProxySight sight = sightFrom(proxy_, origin, direction);
  if (!isSeenFromCapture(sight)) return 0.0f;
  return lights_.pdf(glm::normalize(environment_from_world_ * sight.direction)) * sight.enlargement;
}

glm::vec3 Surroundings::originOfEye(glm::vec3 origin, glm::vec3 direction) const {
  return proxy_.holds(origin) ? origin : formula::nearestToCapture(origin, direction, proxy_.captured_at);
}

std::optional<float> Surroundings::distanceToGround(glm::vec3 origin, glm::vec3 direction) const {
  if (proxy_.kind != ProxyKind::ground || origin.y <= proxy_.ground || !proxy_.holds(origin)) return std::nullopt;
  const formula::ProxyHit hit = hitOf(proxy_, origin, direction);
  return hit.is_ground ? std::optional(hit.distance) : std::nullopt;
}

glm::vec3 Surroundings::albedoOfGround(glm::vec3 seen) const {
  return glm::min(seen / glm::max(ground_irradiance_, glm::vec3(1e-20f)), glm::vec3(1.0f));
}

LightSample Surroundings::sampleOnGround(glm::vec2 u) const {
  LightSample light = lights_.sample(u);
  light.direction = glm::transpose(environment_from_world_) * light.direction;
  if (glm::dot(light.direction, kUp) <= 0.0f) light.pdf = 0.0f;
  return light;
}

float Surroundings::pdfOnGround(glm::vec3 direction) const {
  return lights_.pdf(glm::normalize(environment_from_world_ * direction));
}

}  // namespace mirrorball
