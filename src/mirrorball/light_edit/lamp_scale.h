#pragma once

#include <vector>

#include "mirrorball/base/observer.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/light_edit/lamp_settings.h"
#include "mirrorball/light_edit/map_lamp.h"

namespace mirrorball {

/// A map whose lamps were made brighter or darker.
struct ScaledMap {
  EnvironmentMap map;
  std::vector<MapLamp> lamps;  ///< as they were before; the strongest first
};

/// Multiplies the light of the lamps of an environment by a factor. All other texels stay as they are, bit for bit.
///
/// What is changed is a texel's excess over its surroundings, L − B: below K = 1 to K times that, so that at 0 the
/// surroundings are left; above 1 by g (K − 1) times that, where g makes up for the surroundings behind the strongest
/// lamp, so that it gets K times its irradiance. (All lamps have its g, so that those which touch change alike: a sun
/// has a g of nearly 1, and a halo around it gets less than K times its light.) The glow within 3° of lamps changes as
/// they do by a weight that falls smoothly from 1 to 0, and B is the light at the end of that, so that no edge shows.
///
/// environment  finite; a map in any projection keeps it, and of a function a panorama is made. Lamps are searched in
///              searchedMap of it, with light below 0 taken as 0; such light stays as it is where no lamp is
/// factor       K, at least 0
/// settings     lamps wider than `max_size_deg` stay as they are
/// observer     gets checkLight's remark, and the progress of "convert" and "scale"
/// errors       out_of_range: the light is too bright for a float, or to be summed; too_large; interrupted; as
///              searchedMap's
/// cost         findLamps', 1 µs for each texel of a lamp and of its glow, and 2 ns for each of them and each 1.5° of
///              their border; for a map that is neither a panorama nor a cube a look-up for each texel. Memory: the
///              map, of which no copy is made, a float for each of its texels, and some 100 bytes for each texel that
///              is bright (findLamps); with light below 0, or in a projection that is not searched, the map that is
///              searched, too. Bit-identical for any number of threads
Result<ScaledMap> scaleLamps(Environment environment, float factor, const LampSettings& settings = {},
                             const Observer& observer = {});

}  // namespace mirrorball
