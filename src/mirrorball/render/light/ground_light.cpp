#include "mirrorball/render/light/ground_light.h"

#include <algorithm>

#include "formula/prefilter.h"

namespace mirrorball {

std::optional<GroundLight> groundLightAt(const Environment& environment, const LightSampler& sampler,
                                         const glm::mat3& environment_from_world, glm::vec2 u) {
  constexpr float kLeastHeight = 0.02f;
  const LightSample light = sampler.sample(u);
  const glm::vec3 direction = glm::normalize(glm::transpose(environment_from_world) * light.direction);
  if (light.pdf <= 0.0f || direction.y < kLeastHeight) return std::nullopt;
  return GroundLight{direction, environment.radiance(light.direction) * (direction.y / light.pdf)};
}

GroundLights groundLights(const Environment& environment, const LightSampler& sampler,
                          const glm::mat3& environment_from_world, int count) {
  GroundLights ground;
  const int tried = 16 * count;  // of an environment whose light is mostly below
  int last = 0;
  for (int i = 0; i < tried && int(ground.lights.size()) < count; ++i) {
    last = i + 1;
    const glm::vec2 u = formula::evenPoint(glm::vec2(0.5f), float(i));
    if (const auto light = groundLightAt(environment, sampler, environment_from_world, u))
      ground.lights.push_back(*light);
  }
  glm::vec3 sum(0.0f);
  for (const GroundLight& light : ground.lights) sum += light.share;
  for (GroundLight& light : ground.lights) light.share /= glm::max(sum, glm::vec3(1e-20f));
  ground.irradiance = sum / (formula::kPi * float(std::max(last, 1)));
  return ground;
}

}  // namespace mirrorball
