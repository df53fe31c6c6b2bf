#pragma once

#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "mirrorball/light_edit/map_lamp.h"

namespace mirrorball {

/// What a program needs to know of a map's lamps, and in which axes and units: an array `lights`, the strongest first.
/// Directions are in our axes, towards the light.
nlohmann::ordered_json lampJson(std::span<const MapLamp> lamps);

}  // namespace mirrorball
