#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// A picture of 2:1 with two circles side by side, as cameras with two fisheye lenses back to back write it before it
/// is stitched: on the left what lies in front, +Z in its middle, on the right what lies behind. Both lenses are
/// equidistant: the distance from the centre is proportional to the angle from the lens' axis. Each circle fills its
/// half.
///
/// from   FFmpeg's v360, input `dfisheye`, and Photo Sphere Viewer's dual-fisheye adapter (which circle is in front,
///        both upright); PhotoPrism's CameraFisheyeFov (the field of view, measured with a Ricoh Theta Z1 and two
///        captures of an Insta360 ONE RS, of 186 to 194 degrees)
struct DualFisheye {
  static constexpr double kUsualFov_deg = 190.0;

  std::optional<double> fov_deg = {};       ///< of each circle, at least 180
  std::optional<glm::dvec2> turn_deg = {};  ///< clockwise, after which the left and the right circle are upright
};

/// The name of the form, for FormHint: it is read, and not written.
inline constexpr std::string_view kDualFisheyeName = "dual-fisheye";

/// Takes up one word behind the name: "fov=190", "turn=-90,90" of the left and the right circle, "turn=180" of both.
///
/// errors   usage
Result<void> applyDualFisheyeWord(const std::string& word, DualFisheye& fisheye);

/// The remark on what is assumed of a picture because the caller did not state it; empty: he stated all.
std::string assumedText(const DualFisheye& fisheye);

/// The panorama, as high as the picture, of three channels. Where both circles show a direction, the light changes from
/// one to the other in proportion to the angle.
///
/// picture  2:1, or nearly
/// cost     some 0.3 µs a texel, on one core
Image stitched(const Image& picture, const DualFisheye& fisheye);

}  // namespace mirrorball
