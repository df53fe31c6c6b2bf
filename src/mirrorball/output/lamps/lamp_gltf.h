#pragma once

#include <span>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"
#include "mirrorball/light_edit/map_lamp.h"

namespace mirrorball {

/// Lamps as a .glb file: a directional light of KHR_lights_punctual for each, in a node that turns its −Z into the way
/// its light goes. `color` times `intensity` is the irradiance, in lx where the map's radiance is in cd/m².
///
/// errors   too_large (4 GiB)
/// from     Khronos, glTF 2.0 and its extension KHR_lights_punctual
Result<Bytes> lampGlb(std::span<const MapLamp> lamps);

}  // namespace mirrorball
