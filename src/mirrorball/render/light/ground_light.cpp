#include "mirrorball/render/light/ground_light.h"

#include <algorithm>

#include "formula/bsdf.h"
#include "formula/prefilter.h"
#include "formula/proxy.h"

namespace mirrorball {
namespace {

constexpr float kLeastHeight = 0.02f;  // of light that does not come along the ground

}  // namespace

std::optional<GroundLight> groundLightAt(const Environment& environment, const LightSampler& sampler,
                                         const glm::mat3& environment_from_world, glm::vec2 u) {
  const LightSample light = sampler.sample(u);
  const glm::vec3 direction = glm::normalize(glm::transpose(environment_from_world) * light.direction);
  if (light.pdf <= 0.0f || direction.y < kLeastHeight) return std::nullopt;
  return GroundLight{direction, environment.radiance(light.direction) * (direction.y / light.pdf)};
}

GroundLights groundLights(const Environment& environment, const LightSampler& sampler,
                          const glm::mat3& environment_from_world, int count) {
  const glm::mat3 world_from_environment = glm::transpose(environment_from_world);
  GroundLights ground;
  const int tried = 16 * count;  // of an environment whose light is mostly below
  int last = 0;
  for (int i = 0; i < tried && int(ground.lights.size()) < count; ++i) {
    last = i + 1;
    const glm::vec2 u = formula::evenPoint(glm::vec2(0.5f), float(i / 2));
    const glm::vec3 direction = i % 2 == 0 ? glm::normalize(world_from_environment * sampler.sample(u).direction)
                                           : formula::aboveGround(formula::sampleDiffuse(u));
    if (direction.y < kLeastHeight) continue;
    // Weighed by both ways to choose it (Veach & Guibas 1995, "Optimally combining sampling techniques for Monte Carlo
    // rendering", the balance heuristic).
    const glm::vec3 in_environment = environment_from_world * direction;
    const float pdf = 0.5f * (sampler.pdf(in_environment) + direction.y / formula::kPi);
    ground.lights.push_back({direction, environment.radiance(in_environment) * (direction.y / pdf)});
  }
  glm::vec3 sum(0.0f);
  for (const GroundLight& light : ground.lights) sum += light.share;
  for (GroundLight& light : ground.lights) light.share /= glm::max(sum, glm::vec3(1e-20f));
  ground.irradiance = sum / (formula::kPi * float(std::max(last, 1)));
  return ground;
}

}  // namespace mirrorball
