#pragma once

#include <glm/vec3.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// How a gain map lifts a picture to light that a display may show brighter than white, in each channel:
///
///   light = (picture + offset_sdr) · 2^g − offset_hdr,   g = mix(min_log2, max_log2, code^(1/gamma))
///
/// with the picture's own linear light, white at 1, and the map's codes as shares of the greatest. A display that has
/// less headroom takes a part of g; here it is the whole.
///
/// from     Adobe, Gain Map Specification 1.0, "Applying the gain map"; ISO 21496-1:2025, 6.3
struct GainMap {
  glm::vec3 min_log2{0.0f};
  glm::vec3 max_log2{1.0f};
  glm::vec3 gamma{1.0f};
  glm::vec3 offset_sdr{1.0f / 64.0f};
  glm::vec3 offset_hdr{1.0f / 64.0f};
  float headroom_min_log2 = 0.0f;  ///< of a display, up to which it shows the picture without the map
  float headroom_max_log2 = 1.0f;  ///< from which on it shows the whole of the light

  bool operator==(const GainMap&) const = default;
};

/// Refuses numbers that no writer means: what is not finite, a gamma of 0 or below, a minimum above its maximum, gains
/// beyond 2^±64 and offsets beyond 1024.
///
/// errors   bad_file
Result<void> checkGainMap(const GainMap& gain_map);

/// The light of a picture and its gain map; it is not below 0.
///
/// picture  linear light, 1 or 3 channels
/// codes    of the map, 1 or 3 channels; of any size: between its texels, which cover the picture, they are
///          interpolated
/// gain_map as checkGainMap admits it
/// returns  3 channels, or 1 where both have one
/// cost     O(texels) on all cores
Image lightByGainMap(const Image& picture, const Image8& codes, const GainMap& gain_map);

/// A gain map that was made for a picture.
struct MadeGainMap {
  Image8 codes;  ///< 3 channels, as large as the picture
  GainMap numbers;
};

/// Makes the gain map by which a picture becomes that light again. Its range goes from the least to the greatest gain
/// that is needed, so that no light is too bright for it, and is the same in all channels. Of 255 codes most are for
/// small gains (kMadeGamma), for suns take few texels: a code more is 10 % more light of a sun of 6e4, and much less of
/// what is near white. Measured in docs/conversion.md.
///
/// picture  linear light as a reader has it from the file, 1, 3 or 4 channels
/// light    of the same size; what is negative or NaN counts as 0
/// cost     O(texels) on all cores
MadeGainMap gainMapFor(const Image& picture, const Image& light);

}  // namespace mirrorball
