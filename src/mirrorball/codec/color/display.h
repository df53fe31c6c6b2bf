#pragma once

#include "mirrorball/base/option.h"
#include "mirrorball/codec/color/dither.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

enum class ToneMap { agx, aces, neutral, reinhard, linear };  ///< formula::toneMap's numbers

/// How a display shows radiance.
struct Display {
  float exposure_ev = 0.0f;  ///< stops
  ToneMap tone_map = ToneMap::linear;
  Dither dither = Dither::none;  ///< of pictures of 8 bits

  /// The factor on the radiance, 2^EV.
  float exposure() const;
  bool operator==(const Display&) const = default;
};

/// --exposure and --tone-map, of every command that writes pictures of light.
OptionText exposureText();
OptionText toneMapText();

/// --dither, of what renders pictures. Maps are data for other programs, and are not dithered.
OptionText ditherText();

/// --gain-map, of every command that writes pictures of light as .jpg.
OptionText gainMapText();

/// The light that a display without limits shows: what the picture of displayedPicture is before its tone map.
///
/// image     1, 3 or 4 channels, alpha premultiplied
/// backdrop  as displayedPicture's
/// returns   3 channels, white at 1
Image lightOnDisplay(const Display& display, const Image& image, glm::vec4 backdrop = glm::vec4(0.0f));

/// Converts radiance to the light that a display sends: formula::displayLight, texel by texel. A picture then encodes
/// this light, as it does all linear light.
///
/// image    1 (grey), 3 or 4 channels, alpha premultiplied; in the result, which lies in [0, 1], alpha is straight, as
///          pictures have it
/// cost     up to 0.1 µs a texel
void showOn(const Display& display, Image& image);

/// The light that a display sends of radiance over a background, texel by texel.
///
/// image     4 channels, alpha premultiplied
/// backdrop  light of the display, and 1; 0: none
/// returns   4 channels, straight alpha, in [0, 1]
Image displayedLight(const Display& display, Image image, glm::vec4 backdrop = glm::vec4(0.0f));

/// The picture of that light: formula::displayed, encoded.
Image8 displayedPicture(const Display& display, Image image, glm::vec4 backdrop = glm::vec4(0.0f));

/// Lays an image of four channels, alpha premultiplied, over a light that fills what is left of each texel.
///
/// backdrop  its light, and 1
void layOver(Image& image, glm::vec4 backdrop);

}  // namespace mirrorball
