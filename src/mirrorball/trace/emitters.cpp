#include "mirrorball/trace/emitters.h"

#include <algorithm>
#include <cmath>

#include "formula/constants.h"
#include "mirrorball/scene/relief/relief.h"

namespace mirrorball {
namespace {

// Neither kind of light is left to chance alone where the other one is thought to be brighter: it may be hidden.
constexpr float kLeastShare = 0.2f;
constexpr float kLargestShare = 0.8f;
/// A triangle that is seen from its edge, or touches the place.
constexpr float kLargestDensity = 1e30f;

/// From an area's density to that of directions.
float densityOfDirections(float by_area, float distance, float cosine) {
  return std::min(by_area * distance * distance / std::max(std::abs(cosine), 1e-20f), kLargestDensity);
}

bool isChosen(const Material& material, const TraceSettings& settings) {
  const bool is_used = !settings.is_unoccluded && settings.strategy != LightStrategy::surface;
  const bool is_relief = movesSurface(settings.relief) && material.height_texture >= 0;
  const bool has_layers = material.clearcoat > 0.0f || material.sheen_color != glm::vec3(0.0f);
  return is_used && !is_relief && (material.unlit || !has_layers);
}

}  // namespace

Emitters::Emitters(const Scene& scene, const std::vector<glm::mat3>& world_from_normal, float mean_luminance,
                   const TraceSettings& settings)
    : triangles_(scene, world_from_normal,
                 [&](std::uint32_t instance) { return isChosen(materialOf(scene, instance), settings); }),
      irradiance_of_environment_(formula::kPi * mean_luminance) {}

float Emitters::share(glm::vec3 place) const {
  if (triangles_.empty()) return 0.0f;
  if (irradiance_of_environment_ <= 0.0f) return 1.0f;
  const float irradiance = triangles_.largestIrradiance(place);
  return std::clamp(irradiance / (irradiance + irradiance_of_environment_), kLeastShare, kLargestShare);
}

Emitters::Choice Emitters::chosen(glm::vec3 place, glm::vec3 numbers) const {
  const EmissiveTriangles::Place lamp = triangles_.chosen(numbers);
  const glm::vec3 towards = lamp.position - place;
  const float distance = glm::length(towards);
  if (!(distance > 0.0f)) return {};
  const glm::vec3 direction = towards / distance;
  const float cosine = glm::dot(direction, lamp.hit.geometric_normal);
  return {.sample = {direction, densityOfDirections(lamp.density, distance, cosine)},
          .instance = lamp.hit.instance,
          .triangle = lamp.hit.triangle,
          .position = lamp.position,
          .is_emitter = true};
}

float Emitters::pdf(const Hit& hit, glm::vec3 direction) const {
  return densityOfDirections(triangles_.density(hit), hit.distance, glm::dot(direction, hit.geometric_normal));
}

}  // namespace mirrorball
