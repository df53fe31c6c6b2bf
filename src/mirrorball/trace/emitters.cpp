#include "mirrorball/trace/emitters.h"

#include <algorithm>
#include <cmath>

#include "formula/constants.h"
#include "mirrorball/scene/relief/relief.h"

namespace mirrorball {
namespace {

// Neither kind of light is left to chance alone where the other one is thought to be brighter: it may be hidden.
constexpr float kLeastShare = 0.2f;
constexpr float kLargestShare = 0.9f;
/// A triangle that is seen from its edge, or touches the place.
constexpr float kLargestDensity = 1e30f;

/// From an area's density to that of directions.
float densityOfDirections(float by_area, float distance, float cosine) {
  return std::min(by_area * distance * distance / std::max(std::abs(cosine), 1e-20f), kLargestDensity);
}

}  // namespace

Emitters::Emitters(const Scene& scene, const EmissiveTriangles& triangles, float mean_luminance,
                   const TraceSettings& settings)
    : scene_(scene),
      triangles_(triangles),
      irradiance_of_environment_(formula::kPi * mean_luminance),
      is_used_(!triangles.empty() && !settings.is_unoccluded && settings.strategy != LightStrategy::surface),
      moves_surface_(movesSurface(settings.relief)) {}

float Emitters::share(glm::vec3 place) const {
  if (!is_used_) return 0.0f;
  if (irradiance_of_environment_ <= 0.0f) return 1.0f;
  const float irradiance = triangles_.largestIrradiance(place);
  return std::clamp(irradiance / (irradiance + irradiance_of_environment_), kLeastShare, kLargestShare);
}

/// Not a relief, whose surface is elsewhere than its triangles, nor what lies below layers, which let a share through
/// that only a path finds.
bool Emitters::isChosen(std::uint32_t instance) const {
  const Material& material = materialOf(scene_, instance);
  const bool has_layers = material.clearcoat > 0.0f || material.sheen_color != glm::vec3(0.0f);
  return !(moves_surface_ && material.height_texture >= 0) && (material.unlit || !has_layers);
}

Emitters::Choice Emitters::chosen(glm::vec3 place, glm::vec3 numbers) const {
  const EmissiveTriangles::Place lamp = triangles_.chosen(numbers);
  const glm::vec3 towards = lamp.position - place;
  const float distance = glm::length(towards);
  if (distance <= 0.0f || !isChosen(lamp.hit.instance)) return {};
  const glm::vec3 direction = towards / distance;
  const float cosine = glm::dot(direction, lamp.hit.geometric_normal);
  return {
      {direction, densityOfDirections(lamp.density, distance, cosine)}, lamp.hit.instance, lamp.hit.triangle, distance};
}

float Emitters::pdf(const Hit& hit, glm::vec3 direction) const {
  if (!triangles_.mayShine(hit.instance) || !isChosen(hit.instance)) return 0.0f;
  return densityOfDirections(triangles_.density(hit), hit.distance, glm::dot(direction, hit.geometric_normal));
}

}  // namespace mirrorball
