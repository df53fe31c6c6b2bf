#pragma once

#include <span>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/image/image.h"
#include "mirrorball/light_edit/map_lamp.h"

namespace mirrorball {

/// A panorama with the outlines of its lamps, a little outside of each, and their numbers from 1.
///
/// lamps    of that map
/// returns  3 channels, encoded; at most 1024 rows
/// errors   too_large; interrupted (when `progress` says so)
/// cost     that of converting the map
Result<Image8> lampPicture(const Environment& map, std::span<const MapLamp> lamps, const Display& display,
                           const ProgressFunction& progress = {});

}  // namespace mirrorball
