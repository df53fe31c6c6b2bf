#pragma once

#include <limits>
#include <string>

#include "mirrorball/base/observer.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// How light is changed before anything else is done with it.
struct LightLimits {
  float scale = 1.0f;                                  ///< factor on all light
  float max = std::numeric_limits<float>::infinity();  ///< then the maximum radiance of the brightest channel

  bool areNone() const { return scale == 1.0f && max == std::numeric_limits<float>::infinity(); }
};

/// What a limit took away: luminance over solid angle.
struct LostLight {
  double lost = 0.0;
  double kept = 0.0;

  void add(const LostLight& other) {
    lost += other.lost;
    kept += other.kept;
  }
  /// The share of all light that was lost, in [0, 1].
  double share() const { return lost > 0.0 ? lost / (lost + kept) : 0.0; }
};

/// Scales every texel whose brightest channel is above `max` down to `max`, keeping its hue. Texels that are not finite
/// stay.
///
/// texels   a rectangle of one of the images of a map of that projection
/// extent   of that whole image
/// begin    where in it the first of the texels is
/// returns  the loss, exact to one percent: it uses one solid angle for each of some 128² blocks of texels
/// cost     that of reading the texels
LostLight limitLight(Projection projection, glm::ivec2 extent, glm::ivec2 begin, float max, Image& texels);

/// Scales and limits the light of one of the images of a map, or of a mip level.
LostLight limitLight(Projection projection, const LightLimits& limits, Image& image);

/// Scales and limits the light of a map, or of a function.
LostLight limitLight(EnvironmentMap& map, const LightLimits& limits);
LostLight limitLight(Environment& environment, const LightLimits& limits);

/// "14 %", "5.8 %" or "less than 0.01 %" of the light.
std::string percentOf(const LostLight& light);

/// Remarks how much light a limit took from a map of that name, if any.
void tellLimited(const std::string& name, const LostLight& light, const Observer& observer);

}  // namespace mirrorball
