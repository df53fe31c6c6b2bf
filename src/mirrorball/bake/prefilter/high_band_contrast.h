#pragma once

#include "mirrorball/bake/prefilter/bright_lights.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// How much light a map has in bands that a blur leaves nearly nothing of, against its darkest part: what decides how
/// many bands it takes.
///
/// A map's finest detail is taken for noise that differs from texel to texel: all harmonics then have the same expected
/// power Σ (texel's solid angle · its difference from its four neighbours' mean)² · ⅘ / 4π. Of a lamp with edges that
/// is the power of the highest bands; lower ones have more, as l⁻³ (the edge of a disc),
/// which Lobe::kCheapBands is there for.
///
/// panorama   equirect, of at least 32 × 16 texels
/// without    lights that it still has and that do not count
/// returns    the square root of 4π times that power, over the radiance of the darkest of 16 × 32 parts of the map; of
///            the channel where it is greatest; infinite where a part is black
/// cost       one pass over the texels
float highBandContrast(const EnvironmentMap& panorama, const BrightLights& without);

}  // namespace mirrorball
