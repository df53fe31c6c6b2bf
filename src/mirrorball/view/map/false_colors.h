#pragma once

#include <glm/glm.hpp>

#include "mirrorball/image/image.h"
#include "mirrorball/view/map/map_layout.h"

namespace mirrorball {

/// Stops of a radiance above 1 after the exposure: log₂ of its luminance. Negative infinity where there is none.
float stopsOf(glm::vec3 radiance, float exposure_ev);

/// The false colour of so many stops: metric/picture/color_ramp.h from −range to +range, whose lightness grows evenly.
///
/// range    above 0; what lies beyond it has the colour of its end
/// returns  3 codes of a display and an alpha of 255
glm::vec<4, std::uint8_t> falseColor(float stops, float range);

/// The luminance of an image in false colours.
///
/// light    4 channels, alpha premultiplied
/// paper    where alpha is less than ½
/// returns  4 channels
Image8 falseColors(const Image& light, float exposure_ev, float range, glm::vec<4, std::uint8_t> paper);

/// Draws the colours from −range to +range, with a line at each whole stop.
void drawLegend(const PixelRectangle& place, float range, Image8& picture);

}  // namespace mirrorball
