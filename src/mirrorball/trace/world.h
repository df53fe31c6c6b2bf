#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// All that paths go through.
struct World {
  Scene scene;
  Environment environment;
  LightSampler lights;
  Geometry geometry;
  std::vector<glm::mat3> world_from_normal;  ///< of each instance: normalMatrices
};

}  // namespace mirrorball
