#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// A direction that light comes from, and what part of a level ground's irradiance it stands for.
struct GroundLight {
  glm::vec3 direction{0.0f};  ///< world, unit, upwards
  glm::vec3 share{0.0f};      ///< of all such lights it is 1
};

/// What lights a level ground: directions that are chosen in turn by the environment's light, as many of them at a
/// sun as it has of the light, and by what an even sky would send. Without the latter, the soft shadow beside
/// a strong sun would be a pile of the few silhouettes that are left for the sky.
struct GroundLights {
  std::vector<GroundLight> lights;
  glm::vec3 irradiance{0.0f};  ///< divided by π
};

/// Chooses one, by the light that it brings.
///
/// environment_from_world   turns the environment
/// u                        two uniform numbers
/// returns                  its irradiance in the place of its share: the mean over all u is the ground's. Nothing: it
///                          is below, or comes along the ground, where shadows are endless
std::optional<GroundLight> groundLightAt(const Environment& environment, const LightSampler& sampler,
                                         const glm::mat3& environment_from_world, glm::vec2 u);

/// Chooses them; the same for the same environment.
GroundLights groundLights(const Environment& environment, const LightSampler& sampler,
                          const glm::mat3& environment_from_world, int count);

}  // namespace mirrorball
