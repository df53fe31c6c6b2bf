#pragma once

#include <vector>

#include "mirrorball/environment/environment_map.h"
#include "mirrorball/light_edit/lamp_settings.h"
#include "mirrorball/light_edit/map_lamp.h"
#include "mirrorball/light_edit/map_texel.h"

namespace mirrorball {

/// A lamp, and the texels that its irradiance is the sum of.
struct LampTexels {
  MapLamp lamp;
  std::vector<MapTexel> texels;
};

/// findLamps with the texels of each lamp, none of which belongs to two of them.
std::vector<LampTexels> findLampTexels(const EnvironmentMap& map, glm::vec3 all, const LampSettings& settings);

}  // namespace mirrorball
