#pragma once

#include <glm/glm.hpp>

#include "mirrorball/view/map/map_layout.h"

namespace mirrorball {

// What a hand does to the view of a map. Places are pixels of the picture; what has no view from inside stays as it is.

/// Looks around from inside: what was under the hand stays under it, as far as one can look up and down.
MapViewSettings dragged(MapViewSettings settings, const MapCanvas& canvas, glm::vec2 from_px, glm::vec2 to_px);

/// Looks closer from inside: what is under the pointer stays under it.
///
/// factor   of the tangent of half the field of view, above 0; it stays between kMinFov_deg and kMaxFov_deg
MapViewSettings zoomed(MapViewSettings settings, const MapCanvas& canvas, float factor, glm::vec2 pointer_px);

/// The exposure some stops up or down, within its option's range.
MapViewSettings exposedBy(MapViewSettings settings, float stops);

}  // namespace mirrorball
