#include "mirrorball/trace/surroundings.h"

#include <algorithm>
#include <utility>

#include "formula/constants.h"
#include "formula/prefilter.h"

namespace mirrorball {
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
    const LightSample light = sampleFarAway(formula::sampleOffset(i, kSamples));
    if (light.pdf > 0.0f && light.direction.y > 0.0f)
      ground_irradiance_ +=
          radianceFarAway(light.direction) * (light.direction.y / (formula::kPi * light.pdf * kSamples));
  }
}

glm::vec3 Surroundings::radianceFarAway(glm::vec3 direction) const {
  return intensity_ * environment_.radiance(glm::normalize(environment_from_world_ * direction));
}

glm::vec3 Surroundings::radiance(glm::vec3 origin, glm::vec3 direction) const {
  if (proxy_.kind == ProxyKind::none) return radianceFarAway(direction);
  return radianceFarAway(sightFrom(proxy_, origin, direction).direction);
}

SeenLight Surroundings::seen(glm::vec3 origin, glm::vec3 direction) const {
  if (proxy_.kind == ProxyKind::none) return {radianceFarAway(direction), pdfFarAway(direction)};
  const formula::ProxyHit here = hitOf(proxy_, origin, direction);
  const formula::ProxySight sight = formula::sightOfProxy(here, proxy_.captured_at, direction);
  return {radianceFarAway(sight.direction), pdfOf(here, sight)};
}

/// Whether a ray from a place and one from the capture meet the same place: of triangles, which may hide each other and
/// have holes, they may not.
bool Surroundings::isSame(const formula::ProxyHit& here, const formula::ProxyHit& there) const {
  const bool is_far = here.normal == glm::vec3(0.0f);
  if (is_far || there.normal == glm::vec3(0.0f)) return is_far && there.normal == glm::vec3(0.0f);
  constexpr float kSame = 1e-3f;
  return glm::distance(here.place, there.place) <= kSame * glm::distance(proxy_.captured_at, there.place);
}

LightSample Surroundings::sample(glm::vec3 origin, glm::vec2 u) const {
  LightSample light = sampleFarAway(u);
  if (proxy_.kind == ProxyKind::none) return light;
  const formula::ProxyHit there = hitOf(proxy_, proxy_.captured_at, light.direction);
  if (there.normal != glm::vec3(0.0f)) {
    const glm::vec3 towards = there.place - proxy_.within(origin);
    if (towards == glm::vec3(0.0f)) return {};
    light.direction = glm::normalize(towards);
  }
  const formula::ProxyHit here = hitOf(proxy_, origin, light.direction);
  const formula::ProxySight sight = formula::sightOfProxy(here, proxy_.captured_at, light.direction);
  light.pdf *= isSame(here, there) ? sight.enlargement : 0.0f;
  return light;
}

float Surroundings::pdfOf(const formula::ProxyHit& here, const formula::ProxySight& sight) const {
  if (proxy_.kind == ProxyKind::mesh && !isSame(here, hitOf(proxy_, proxy_.captured_at, sight.direction))) return 0.0f;
  return pdfFarAway(sight.direction) * sight.enlargement;
}

glm::vec3 Surroundings::originOfEye(glm::vec3 origin, glm::vec3 direction) const {
  return proxy_.holds(origin) ? origin : formula::nearestToCapture(origin, direction, proxy_.captured_at);
}

std::optional<float> Surroundings::distanceToGround(glm::vec3 origin, glm::vec3 direction) const {
  if (proxy_.kind != ProxyKind::ground || direction.y >= 0.0f || origin.y <= proxy_.ground || !proxy_.holds(origin))
    return std::nullopt;
  const formula::ProxyHit hit = hitOf(proxy_, origin, direction);
  return hit.is_ground ? std::optional(hit.distance) : std::nullopt;
}

glm::vec3 Surroundings::albedoOfGround(glm::vec3 seen) const {
  return glm::min(seen / glm::max(ground_irradiance_, glm::vec3(1e-20f)), glm::vec3(1.0f));
}

LightSample Surroundings::sampleFarAway(glm::vec2 u) const {
  LightSample light = lights_.sample(u);
  light.direction = glm::transpose(environment_from_world_) * light.direction;
  return light;
}

float Surroundings::pdfFarAway(glm::vec3 direction) const {
  return lights_.pdf(glm::normalize(environment_from_world_ * direction));
}

}  // namespace mirrorball
