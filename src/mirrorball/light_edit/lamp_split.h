#pragma once

#include <vector>

#include "mirrorball/bake/prefilter/bright_lights.h"
#include "mirrorball/environment/environment_map.h"
#include "mirrorball/light_edit/lamp_settings.h"
#include "mirrorball/light_edit/map_lamp.h"

namespace mirrorball {

/// A lamp that was taken out of a map.
struct TakenLamp {
  MapLamp lamp;                     ///< its irradiance is what was taken, its direction towards the middle of that
  std::vector<PointOfLight> light;  ///< the same light as it lay in the map: a point for each texel
};

/// A map without its small lamps, and those lamps: together the light of the map.
struct SplitMap {
  EnvironmentMap rest;
  std::vector<TakenLamp> taken;    ///< the strongest first
  std::vector<MapLamp> kept = {};  ///< those that are wider, and stay in the map
};

/// Takes lamps of up to `max_size_rad` out of a map. Around each a cap is chosen that ends where the light is no
/// brighter than the sky around it, at most glowReach_rad away from the lamp. What was behind it is the harmonic
/// function that has the sky's light along the cap's edge: by Poisson's formula the mean of that light, weighed by the
/// reciprocal of the squared distance. Texels darker than that, such as leaves before a sun, stay as they are, so that
/// nothing becomes brighter or negative.
///
/// map      in which the lamps were found: a panorama or a cube
/// lamps    findLamps of it
/// cost     a test for each 16 × 16 texels of the map a lamp, and 0.1 ms for each row of texels that its cap is high;
///          bit-identical for any number of threads
/// from     Poisson's formula holds on a cap as in a plane: stereographic projection keeps harmonic functions, and
///          squared distances but for factors that cancel in a mean over a circle
SplitMap splitLamps(EnvironmentMap map, const std::vector<MapLamp>& lamps, float max_size_rad);

/// The same of the lamps that are found in it.
///
/// map      a panorama or a cube; finite, not negative
/// cost     wholeLight's, findLamps' and splitLamps'
SplitMap splitMap(EnvironmentMap map, const LampSettings& settings = {});

/// The lamps that were taken out.
std::vector<MapLamp> takenLamps(const SplitMap& split);

}  // namespace mirrorball
