#pragma once

#include <string>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/cube/cube_arrangement.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

struct LoadedEnvironment;

/// Where the middle of a panorama points, as cameras and stitching programs store it.
struct CompassHeading {
  double heading_deg = 0.0;  ///< clockwise from north as seen from above, 0 … 360
  double pitch_deg = 0.0;    ///< above the horizon, −90 … 90
  double roll_deg = 0.0;  ///< of the camera, clockwise as it looks: the horizon turns counter-clockwise; −180 … 180
  bool is_magnetic = false;  ///< from the magnetic pole, not from the geographic one
  std::string source = {};   ///< the field that it comes from: "GPano:PoseHeadingDegrees"
};

/// Directions of the world in a map (unit), in our axes.
struct CompassAxes {
  glm::vec3 north;
  glm::vec3 up;
};

/// Where north and up are in a panorama.
///
/// centre   our direction in the middle of its picture: MapForm::centre
/// from     Google, Photo Sphere XMP Metadata: PoseHeadingDegrees, PosePitchDegrees, PoseRollDegrees
CompassAxes compassAxes(const CompassHeading& heading, SignedAxis centre = SignedAxis::plus_z);

/// Turns directions of a level panorama, in which up is up and the middle is the point of the horizon under or above
/// the picture's middle, into those of a picture that was taken with the camera tilted. Both have +Z in their middle.
///
/// pitch_deg, roll_deg   as in CompassHeading
glm::mat3 pictureFromLevel(double pitch_deg, double roll_deg);

/// A panorama whose picture was taken with the camera tilted, upright: resampled (bicubic), three channels.
///
/// centre   our direction in the middle of its picture: MapForm::centre
/// errors   too_large
/// cost     convert's
Result<EnvironmentMap> levelled(EnvironmentMap panorama, double pitch_deg, double roll_deg, SignedAxis centre);

/// Whether a map has a middle that a compass heading can be of.
///
/// errors   bad_shape: it is not a panorama. Without the map's name
Result<void> checkTakesHeading(const LoadedEnvironment& loaded);

/// Where north is in a panorama.
struct NorthInfo {
  CompassHeading heading;
  CompassAxes axes;
  float column = 0.0f;  ///< of the file's picture, or of the whole panorama that it is a part of [texels]
  int columns = 0;      ///< how many that has
};

/// Finds north in a panorama by the heading that its file states; in one that was levelled, by the heading alone.
///
/// errors   as checkTakesHeading's
Result<NorthInfo> findNorth(const CompassHeading& heading, const LoadedEnvironment& loaded);

}  // namespace mirrorball
