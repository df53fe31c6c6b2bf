#pragma once

#include "mirrorball/environment/environment_map.h"
#include "mirrorball/environment/file/compass_heading.h"

namespace mirrorball {

/// Draws a mark into a panorama where north is: a white line with a dark edge, from 8° below the horizon to 5° above
/// it, and the letter N on it. In panoramas of fewer than 514 rows it is as large as their texels need. White is four
/// times the mean light of the map around the mark, and at least 1, so that it is seen in any unit of light.
///
/// panorama  an equirect
/// axes      of the panorama, in our axes
void drawNorth(const CompassAxes& axes, EnvironmentMap& panorama);

}  // namespace mirrorball
