#pragma once

#include <memory>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment.h"
#include "mirrorball/scene/proxy/proxy.h"

namespace mirrorball {

/// The environment as frames show it: turned, scaled, and near where it has a proxy.
struct LightAround {
  std::shared_ptr<const Environment> environment = {};  ///< null: it is dark
  glm::mat3 environment_from_world{1.0f};               ///< FrameSettings::environmentFromWorld
  float intensity = 1.0f;                               ///< scales its light
  Proxy proxy = {};                                     ///< what the light comes from; a ground is no surface here
};

/// The direction in which a map of the environment shows what a ray sees that meets nothing.
///
/// direction  world, unit
/// returns    in the environment's own axes, unit
glm::vec3 environmentDirection(const LightAround& around, glm::vec3 origin, glm::vec3 direction);

/// The same for a ray of an eye, which sees through the wall of a proxy that it stands outside of.
glm::vec3 environmentDirectionOfEye(const LightAround& around, glm::vec3 origin, glm::vec3 direction);

/// The light that comes from there.
///
/// direction  in the environment's own axes, unit
/// returns    linear radiance, scaled
glm::vec3 radianceOf(const LightAround& around, glm::vec3 direction);

}  // namespace mirrorball
