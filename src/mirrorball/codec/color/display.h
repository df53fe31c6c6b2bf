#pragma once

#include "mirrorball/base/option.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

enum class ToneMap { agx, aces, neutral, reinhard, linear };  ///< formula::toneMap's numbers

/// How a display shows radiance.
struct Display {
  float exposure_ev = 0.0f;  ///< stops
  ToneMap tone_map = ToneMap::linear;

  /// The factor on the radiance, 2^EV.
  float exposure() const;
  bool operator==(const Display&) const = default;
};

/// --exposure and --tone-map, of every command that writes pictures of light.
OptionText exposureText();
OptionText toneMapText();

/// Converts radiance to the light that a display sends: formula::displayLight, texel by texel. A picture then encodes
/// this light, as it does all linear light.
///
/// image    1 (grey), 3 or 4 channels, alpha premultiplied; in the result, which lies in [0, 1], alpha is straight, as
///          pictures have it
/// cost     up to 0.1 µs a texel
void showOn(const Display& display, Image& image);

}  // namespace mirrorball
